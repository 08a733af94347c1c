"""The paper's experiments: its four figures, and its archived results to compare with.

Each figure's file keeps the runs apart from the drawing.
"""

from divbandit.paper.comparison import Comparison, compare
from divbandit.paper.reproduce import reproduce

__all__ = ["Comparison", "compare", "reproduce"]
