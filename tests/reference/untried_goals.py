"""UntriedGoals in plain Python: the specification that the kernel is held to, bit by bit."""

import math
from collections import deque

import numpy as np

import divbandit as db
from tests.reference.nearest import nearest


class UntriedGoals:
    """Uncovered goals near the effects that fewest were near to, or just beyond the border."""

    def __init__(self, tau, candidates, tries, reach, box=None):
        self.tau, self.candidates, self.tries, self.reach = tau, candidates, tries, reach
        self.box = box
        self.counts = {}  # how many goals were near to an effect
        self.turns = deque()  # effects that may lie at the border
        self.queued = 0

    def sample(self, history, rng):
        """Draw a goal for a history that is not empty."""
        effects, tau = history.effects, self.tau
        box = self.box or around(effects, tau)
        best = None
        found = 0
        for _ in range(self.tries):
            point = box.sample(rng)
            distance, index = (each[0] for each in nearest(effects, point))
            if distance <= tau:
                continue
            count = self.counts.get(index, 0)
            if best is None or count < best[0]:
                best = count, point, distance, index
            found += 1
            if count == 0 or found == self.candidates:
                break
        if best is None:
            goal = self.beyond_the_border(effects, box, rng)
            return point if goal is None else goal
        count, goal, distance, index = best
        self.counts[index] = count + 1
        if distance > self.reach * tau:
            goal = effects[index] + (goal - effects[index]) * (self.reach * tau / distance)
            goal = np.clip(goal, box.low, box.high)
        return goal

    def beyond_the_border(self, effects, box, rng):
        """Draw a goal beyond the effects in turn; None if twenty lie inside."""
        self.turns.extendleft(range(self.queued, len(effects)))
        self.queued = len(effects)
        for _ in range(20):
            if not self.turns:
                return None
            index = self.turns.popleft()
            for _ in range(8):
                direction = np.array([2.0 * rng.random() - 1.0 for _ in range(box.dim)])
                length = math.sqrt(sum((direction**2).tolist()))
                if length == 0.0:
                    continue
                point = effects[index] + direction * (1.02 * self.tau / length)
                if not box.contains(point) or nearest(effects, point)[0][0] <= self.tau:
                    continue
                self.turns.append(index)
                distance = self.tau * (1.0 + (self.reach - 1.0) * rng.random())
                goal = effects[index] + direction * (distance / length)
                return np.clip(goal, box.low, box.high)
        return None


def around(effects, tau):
    """Return the box of all effects, wider by a twentieth and by two tau on either side."""
    low, high = effects.min(axis=0), effects.max(axis=0)
    margin = 0.05 * (high - low) + 2.0 * tau
    return db.Box(low - margin, high + margin)
