"""The estimators as plain lists, in fractions where they are exact."""

from collections import deque
from dataclasses import fields
from fractions import Fraction


def started(value, parts, largest):
    """Return the specification of what a library's estimator starts."""
    arguments = {each.name: getattr(value, each.name) for each in fields(value)}
    return KINDS[type(value).__name__](parts=parts, largest=largest, **arguments)


def mean(rewards):
    """Return the mean, of a sum that is exact before it is rounded once."""
    return float(sum(map(Fraction, rewards))) / len(rewards) if rewards else 0.0


class Estimator:
    """What all share: the largest reward, given or the largest so far."""

    def __init__(self, parts, largest):
        self.parts = range(parts)
        self.largest, self.bounded = largest, largest > 0.0

    def add(self, part, reward):
        if not self.bounded:
            self.largest = max(self.largest, abs(reward))
        self.remember(part, reward)


class Kept(Estimator):
    """One that holds rewards one by one, `self.kept(part)`."""

    @property
    def means(self):
        return [mean(self.kept(part)) for part in self.parts]

    @property
    def counts(self):
        return [float(len(self.kept(part))) for part in self.parts]


class Window(Kept):
    def __init__(self, parts, largest, size, head_start):
        super().__init__(parts, largest)
        self.windows = [deque([largest] * head_start, maxlen=size) for _ in self.parts]

    def kept(self, part):
        return self.windows[part]

    def remember(self, part, reward):
        self.windows[part].append(reward)


class RecentWindow(Kept):
    def __init__(self, parts, largest, size):
        super().__init__(parts, largest)
        self.window = deque(maxlen=size)

    def kept(self, part):
        return [reward for owner, reward in self.window if owner == part]

    def remember(self, part, reward):
        self.window.append((part, reward))


class WholePast(Kept):
    def __init__(self, parts, largest):
        super().__init__(parts, largest)
        self.rewards = [[] for _ in self.parts]

    def kept(self, part):
        return self.rewards[part]

    def remember(self, part, reward):
        self.rewards[part].append(reward)


class Discounted(Estimator):
    def __init__(self, parts, largest, gamma, head_start):
        super().__init__(parts, largest)
        self.gamma, self.means, self.counts = gamma, [0.0] * parts, [0.0] * parts
        for _ in range(head_start):
            for part in self.parts:
                self.add(part, largest)

    def remember(self, part, reward):
        self.counts = [self.gamma * count for count in self.counts]
        self.counts[part] += 1.0
        self.means[part] += (reward - self.means[part]) / self.counts[part]


KINDS = {kind.__name__: kind for kind in (Window, RecentWindow, WholePast, Discounted)}
