"""Tests of divbandit.studies."""
