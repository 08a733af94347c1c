"""Experiments: many explorations, spread over processes."""

from divbandit.experiments.parallel import run_all

__all__ = ["run_all"]
