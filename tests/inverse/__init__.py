"""Tests of the inverse models."""
