"""Tests of divbandit; they mirror the package."""
