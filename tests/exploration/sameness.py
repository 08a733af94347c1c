"""Whether two runs are the same, bit by bit, and where they part if they are not."""

ARRAYS = ("commands", "effects", "paths", "diversities", "choices")


def differences(run, other):
    """Return in words what differs between two runs; nothing where they are the same."""
    found = [
        f"{name}: {getattr(run, name)} and {getattr(other, name)}"
        for name in ("motor_space", "sensory_space")
        if getattr(run, name) != getattr(other, name)
    ]
    for name in ARRAYS:
        one, two = getattr(run, name), getattr(other, name)
        if one is None or two is None:
            if one is not two:
                found.append(f"{name}: {one} and {two}")
        elif (one.dtype.str, one.shape) != (two.dtype.str, two.shape):
            found.append(f"{name}: {one.dtype} {one.shape} and {two.dtype} {two.shape}")
        elif one.tobytes() != two.tobytes():
            step = next(i for i in range(len(one)) if one[i].tobytes() != two[i].tobytes())
            found.append(f"{name}: from step {step} on, {one[step]!r} and {two[step]!r}")
    return found
