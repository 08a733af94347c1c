"""Tests of the goal samplers."""
