"""A loop with callbacks, as `Explorer.run` has it: to be replaced by that."""

import math
import time
from contextlib import ExitStack

import divbandit as db
from divbandit._duration import seconds
from divbandit.callbacks.protocol import check_callback, start_callback


def run(explorer, environment, n, *, on_error="raise", callbacks=()):
    """Make `n` evaluations, or as many as there are until a callback returns True."""
    for index, callback in enumerate(callbacks):
        check_callback(f"callbacks[{index}]", callback)
    with ExitStack() as stack:
        watchers = []
        for callback in callbacks:
            running = start_callback(callback, explorer, n)
            stack.callback(getattr(running, "close", lambda: None))
            watchers.append(calling(running, getattr(callback, "every", 1)))
        for _ in range(n):
            trial = explorer.ask()
            try:
                effect = environment(trial.command)
            except ValueError as error:
                if on_error == "raise":
                    raise
                explorer.fail(trial, f"{type(error).__name__}: {error}")
            else:
                explorer.tell(trial, effect)
            answers = [watcher(explorer, trial) for watcher in watchers]
            if any(answer is True for answer in answers):
                break
    return explorer.result()


def calling(running, every):
    """Return what calls a callback when it is due."""
    trials, period = (math.inf, seconds("every", every)) if isinstance(every, str) else (every, 0)
    state = {"left": trials, "due": time.monotonic() + (period or math.inf)}

    def call(explorer, trial):
        state["left"] -= 1
        if state["left"] > 0 and time.monotonic() < state["due"]:
            return None
        state.update(left=trials, due=time.monotonic() + (period or math.inf))
        return running(explorer, trial)

    return call


def explore(environment, strategy, n, *, rng=None, **options):
    """Make an explorer, and run it."""
    spaces = environment.motor_space, environment.sensory_space
    return run(db.Explorer(strategy, *spaces, rng=rng), environment, n, **options)
