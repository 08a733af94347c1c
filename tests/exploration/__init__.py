"""Tests of running, saving and loading explorations."""
