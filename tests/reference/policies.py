"""The policies in plain Python; every operation in the order that decides the last bit."""

from dataclasses import fields
from math import e, inf, sqrt

from divbandit._core import exp, log, normal_quantile, power


def started(value, parts, largest):
    """Return the specification of what a library's policy starts."""
    arguments = {each.name: getattr(value, each.name) for each in fields(value)}
    return KINDS[type(value).__name__](parts, largest, **arguments)


def total_of(numbers):
    """Return the sum in plain order."""
    total = 0.0
    for number in numbers:
        total += number
    return total


def proportionally(weights, u):
    """Return an index with probability proportional to its weight; uniformly if all are 0."""
    total = total_of(weights)
    if total <= 0.0:
        return int(u * len(weights))
    left = u * total
    for index, weight in enumerate(weights):
        if left < weight:
            return index
        left -= weight
    return max(index for index, weight in enumerate(weights) if weight > 0.0)


def powers(means, exponent):
    """Return powers of the means' shares of the largest; for 1 the means themselves."""
    weights = [max(0.0, mean) for mean in means]
    if exponent == 1.0:
        return weights
    top = max(weights)
    return [power(weight / top, exponent) if weight > 0.0 else 0.0 for weight in weights]


def best(values):
    """Return where the largest values are."""
    return [index for index, value in enumerate(values) if value == max(values)]


class Policy:
    """What all share; each sets itself up in `begin` and has `choose`."""

    def __init__(self, parts, largest, **parameters):
        self.parts, self.largest, self.bounded = parts, largest, largest > 0.0
        self.__dict__ |= parameters
        self.begin()

    def begin(self):
        """Set up what changes."""

    def learn(self, part, reward, probability):
        """Learn nothing."""

    def share(self, reward):
        """Return a reward as a share of the largest, in [0, 1]."""
        if not self.bounded:
            self.largest = max(self.largest, abs(reward))
        return min(1.0, reward / self.largest) if reward > 0.0 else 0.0


class Proportional(Policy):
    def choose(self, estimates, rng):
        weights = powers(estimates.means, self.power)
        total, count = total_of(weights), len(weights)
        uniformly, u = rng.random() < self.alpha, rng.random()
        index = int(u * count) if uniformly else proportionally(weights, u)
        if total <= 0.0:
            return index, 1.0 / count
        probability = self.alpha / count + (1.0 - self.alpha) * weights[index] / total
        return index, min(1.0, probability)


class EpsilonGreedy(Policy):
    def choose(self, estimates, rng):
        uniformly, u = rng.random() < self.epsilon, rng.random()
        ties = best(estimates.means)
        index = int(u * self.parts) if uniformly else ties[int(u * len(ties))]
        probability = self.epsilon / self.parts
        if index in ties:
            probability += (1.0 - self.epsilon) / len(ties)
        return index, min(1.0, probability)


class Softmax(Policy):
    def choose(self, estimates, rng):
        means, unit = estimates.means, estimates.largest if self.scaled else 1.0
        weights = [1.0] * len(means)
        if unit > 0.0:
            exponents = [(mean - max(means)) / unit / self.temperature for mean in means]
            weights = [exp(x) if x > -1e3 else 0.0 for x in exponents]
        index = proportionally(weights, rng.random())
        return index, weights[index] / total_of(weights)


class UCB(Policy):
    def begin(self):
        self.asked = [0] * self.parts  # of each, how often without being told

    def choose(self, estimates, rng):
        counts = [n + asked for n, asked in zip(estimates.counts, self.asked, strict=True)]
        known = self.xi * log(max(1.0, total_of(counts)))
        bounds = [
            mean + estimates.largest * sqrt(known / count) if count > 0.0 else inf
            for mean, count in zip(estimates.means, counts, strict=True)
        ]
        ties = best(bounds)
        index = ties[int(rng.random() * len(ties))]
        self.asked[index] += 1
        return index, 1.0 / len(ties)

    def learn(self, part, reward, probability):
        del reward, probability
        self.asked[part] = max(0, self.asked[part] - 1)


class Thompson(Policy):
    def choose(self, estimates, rng):
        scale = estimates.largest or 1.0
        sampled = [
            mean + scale / sqrt(count + 1.0) * normal_quantile(rng.random() or 2.0**-54)
            for mean, count in zip(estimates.means, estimates.counts, strict=True)
        ]
        return best(sampled)[0], None


class Exp3(Policy):
    def begin(self):
        self.logs = [0.0] * self.parts

    def weights(self):
        return [exp(x) for x in self.logs]

    def probabilities(self):
        weights = self.weights()
        total, equal = total_of(weights), self.gamma / self.parts
        return [(1.0 - self.gamma) * weight / total + equal for weight in weights]

    def choose(self, estimates, rng):
        del estimates
        probabilities = self.probabilities()
        index = proportionally(probabilities, rng.random())
        return index, min(1.0, probabilities[index])

    def growth(self, part, reward, probability):
        chosen = self.probabilities()[part] if probability is None else probability
        return self.gamma * (self.share(reward) / chosen) / self.parts

    def learn(self, part, reward, probability):
        self.logs[part] += self.growth(part, reward, probability)
        self.logs = [x - max(self.logs) for x in self.logs]


class Exp3S(Exp3):
    def begin(self):
        self.shares = [1.0 / self.parts] * self.parts

    def weights(self):
        return self.shares

    def learn(self, part, reward, probability):
        growth = self.growth(part, reward, probability)
        more = e * self.alpha / self.parts * total_of(self.shares)
        self.shares[part] *= exp(min(700.0, growth))
        grown = [share + more for share in self.shares]
        self.shares = [share / total_of(grown) for share in grown]


class RoundRobin(Policy):
    def begin(self):
        self.next = 0

    def choose(self, estimates, rng):
        del estimates, rng
        index, self.next = self.next, (self.next + 1) % self.parts
        return index, 1.0


class Uniform(Policy):
    def choose(self, estimates, rng):
        del estimates
        return int(rng.random() * self.parts), 1.0 / self.parts


KINDS = {
    kind.__name__: kind
    for kind in (
        Proportional,
        EpsilonGreedy,
        Softmax,
        UCB,
        Thompson,
        Exp3,
        Exp3S,
        RoundRobin,
        Uniform,
    )
}
