"""Tests of divbandit.controllers."""
