"""The benchmark: `default_strategy` and its peers on the field's problems."""

from divbandit.studies.benchmark.benchmark import benchmark

__all__ = ["benchmark"]
