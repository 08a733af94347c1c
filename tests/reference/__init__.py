"""Slow, plain oracles: anyone can check them by eye."""
