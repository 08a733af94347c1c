"""The hard maze by its published rules: every step, every wall, Python's own sines.

The rules are those of Lehman and Stanley's program (``maze.h`` of Novelty Search C++ 1.0), the
network is that of `divbandit.benchmarks.Maze`.
"""

import math

#: x1 y1 x2 y2 of each wall, as in ``hard_maze.txt``.
WALLS = [
    tuple(map(float, line.split()))
    for line in """
    41 5 3 8
    3 8 4 49
    4 49 57 53
    4 49 7 202
    7 202 195 198
    195 198 186 8
    186 8 39 5
    56 54 56 157
    57 106 158 162
    77 201 108 164
    6 80 33 121
    192 146 87 91
    56 55 133 30
    """.strip().splitlines()
]
START, GOAL = (36.0, 184.0), (31.0, 20.0)
RANGE_FINDERS = (-90, -45, 0, 45, 90, -180)
QUARTERS = ((315, 405), (45, 135), (135, 225), (225, 315))
HIDDEN = 5


def crossing(wall, x, y, to_x, to_y):
    """Return how far from (x, y) its line to another point crosses a wall; None if it does not."""
    ax, ay, bx, by = wall
    below = (bx - ax) * (to_y - y) - (by - ay) * (to_x - x)
    if below == 0:
        return None
    r = ((ay - y) * (to_x - x) - (ax - x) * (to_y - y)) / below
    s = ((ay - y) * (bx - ax) - (ax - x) * (by - ay)) / below
    if not (0 < r < 1 and 0 < s < 1):
        return None
    return math.hypot(ax + r * (bx - ax) - x, ay + r * (by - ay) - y)


def distance(wall, x, y):
    """Return how far a point is from a wall."""
    ax, ay, bx, by = wall
    u = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
    if u < 0 or u > 1:
        return min(math.hypot(x - ax, y - ay), math.hypot(x - bx, y - by))
    return math.hypot(ax + u * (bx - ax) - x, ay + u * (by - ay) - y)


def senses(x, y, heading):
    """Return the inputs: a bias, how far walls are, in which quarter the goal is."""
    inputs = [1.0]
    for angle in RANGE_FINDERS:
        way = math.radians(angle + heading)
        to = x + 100 * math.cos(way), y + 100 * math.sin(way)
        found = [crossing(wall, x, y, *to) for wall in WALLS]
        inputs.append(min([100.0, *(each for each in found if each is not None)]) / 100)
    bearing = math.degrees(math.atan2(GOAL[1] - y, GOAL[0] - x)) - heading
    bearing %= 360
    for low, high in QUARTERS:
        inputs.append(float(low <= bearing < high or low <= bearing + 360 < high))
    return inputs


def logistic(weights, inputs):
    """Return what a unit of NEAT gives."""
    total = math.fsum(weight * each for weight, each in zip(weights, inputs, strict=True))
    return 1 / (1 + math.exp(-4.924273 * total))


def outputs(weights, inputs):
    """Return what the network gives: angular velocity and speed, from 0 to 1."""
    width = len(inputs)
    units = [weights[unit * width : (unit + 1) * width] for unit in range(HIDDEN)]
    hidden = [1.0, *(logistic(unit, inputs) for unit in units)]
    last = weights[HIDDEN * width :]
    return logistic(last[: HIDDEN + 1], hidden), logistic(last[HIDDEN + 1 :], hidden)


def limited(value):
    return max(-3.0, min(3.0, value))


def path(weights):
    """Return where the robot is at the start and after each step, until it has arrived."""
    (x, y), heading, speed, angular_velocity = START, 0.0, 0.0, 0.0
    places = [(x, y)]
    for _ in range(400):
        turn, faster = outputs(weights, senses(x, y, heading))
        angular_velocity = limited(angular_velocity + turn - 0.5)
        speed = limited(speed + faster - 0.5)
        new_x = x + math.cos(math.radians(heading)) * speed
        new_y = y + math.sin(math.radians(heading)) * speed
        heading += angular_velocity
        if heading > 360:
            heading -= 360
        if heading < 0:
            heading += 360
        if all(distance(wall, new_x, new_y) >= 8 for wall in WALLS):
            x, y = new_x, new_y
        places.append((x, y))
        if math.hypot(x - GOAL[0], y - GOAL[1]) < 5:
            break
    return places
