"""Measures of diversity: what a set of effects covers, and what one more effect adds."""

from divbandit._core import Coverage, coverage

__all__ = ["Coverage", "coverage"]
