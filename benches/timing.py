"""How long some work takes at best."""

import time


def fastest(work, *, repeat):
    """Return the least time that `work` took, and its result."""
    times = []
    for _ in range(repeat):
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
    return min(times), result
