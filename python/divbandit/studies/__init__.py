"""Studies: which bandit, of how many strategies, made of which parts, where.

Each study's file keeps the runs apart from the drawing.
"""

from divbandit.studies.study import study

__all__ = ["study"]
