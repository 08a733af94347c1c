"""GridGoals in plain Python: the specification that the kernel is held to, bit by bit."""

import math


class GridGoals:
    """Goals uniform in the cells of a grid, all cells in random order, then all again."""

    def __init__(self, cells, box):
        self.shape = (cells,) * box.dim if isinstance(cells, int) else tuple(cells)
        self.box = box
        self.left = []  # the cells still to come in this round

    def sample(self, rng):
        """Draw the cell, and then the place in it, coordinate by coordinate."""
        left = self.left
        if not left:
            left.extend(range(math.prod(self.shape)))
        place = int(rng.random() * len(left))
        left[place], left[-1] = left[-1], left[place]
        cell = left.pop()
        goal = []
        corners = zip(self.box.low.tolist(), self.box.high.tolist(), self.shape, strict=True)
        for low, high, count in corners:
            cell, column = divmod(cell, count)
            share = (column + rng.random()) / count
            goal.append(min(low + (high - low) * share, high))
        return goal
