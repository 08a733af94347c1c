"""Whether two runs are the same, bit by bit, and where they part if they are not."""

ARRAYS = ("commands", "effects", "paths", "estimates", "choices")


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
    one, two = ([(f.command.tolist(), *f[1:]) for f in each.failures] for each in (run, other))
    if one != two:
        found.append(f"failures: {one} and {two}")
    return found


def everything(explorer):
    """Return all that an explorer is and has been, comparable with ==."""
    run = explorer.result()
    return (
        run.commands.tobytes(),
        run.effects.tobytes(),
        run.paths.tolist(),
        None if run.estimates is None else run.estimates.tobytes(),
        explorer.estimates,
        [(f.command.tolist(), *f[1:]) for f in run.failures],
        [
            (
                t.number,
                list(t.command),
                t.path,
                t.probability,
                None if t.goal is None else list(t.goal),
            )
            for t in explorer.open_trials
        ],
        str(explorer.rng.bit_generator.state),
    )
