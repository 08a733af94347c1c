"""An explorer that was saved and loaded goes on bit by bit as it would have."""

from contextlib import suppress

import numpy as np
import pytest

import divbandit as db
from divbandit.adapters import OptunaSampler, RibsEmitter
from divbandit.exploration.blocks import packed, unpacked
from tests.compositions import NAMES, adapted, built_in, compositions
from tests.exploration.sameness import everything

ARM = db.PlanarArm(4)


def new_explorer(strategy, rng=0, goals=ARM.sensory_space):
    return db.Explorer(strategy, ARM.motor_space, goals, rng=rng)


def live(explorer, chance, steps):
    """Ask for one or many, tell late and in any order, singly and in lists, and fail."""
    for _ in range(steps):
        if chance.random() < 0.3:
            explorer.ask(int(chance.integers(1, 6)))
        else:
            explorer.ask()
        under_way = list(explorer.open_trials)
        chance.shuffle(under_way)
        done = under_way[: chance.integers(0, len(under_way) + 1)]
        if chance.random() < 0.3:
            explorer.tell(done, ARM(np.array([t.command for t in done]).reshape(-1, 4)))
        else:
            for trial in done:
                if chance.random() < 0.2:
                    explorer.fail(trial, f"reason {trial.number}")
                else:
                    explorer.tell(trial, ARM(trial.command))


@pytest.mark.parametrize("name", NAMES)
def test_it_goes_on_as_it_would_have(name, tmp_path):
    strategy = compositions()[name]
    explorer = new_explorer(strategy)
    live(explorer, np.random.default_rng(1), 30)
    explorer.save(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run", strategy)
    assert everything(again) == everything(explorer)
    for each in (explorer, again):
        live(each, np.random.default_rng(2), 30)
    assert everything(again) == everything(explorer)
    again.save(tmp_path / "twice")
    thrice = db.Explorer.load(tmp_path / "twice", strategy)
    assert everything(thrice) == everything(explorer)


#: Adapters with plain arguments are in the file as well.
PLAIN = {"adapters": db.Mixture([RibsEmitter("line", cells=7), OptunaSampler()])}


@pytest.mark.parametrize("name", [*built_in(), *PLAIN])
def test_built_in_parts_need_not_be_given(name, tmp_path):
    strategy = (built_in() | PLAIN)[name]
    explorer = new_explorer(strategy)
    live(explorer, np.random.default_rng(1), 20)
    explorer.save(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run")
    assert repr(again) == repr(explorer)
    assert everything(again) == everything(explorer)


def test_a_part_that_occurs_twice_is_one_again(tmp_path):
    shared = db.Schedule([(3, db.MotorBabbling()), (None, db.GoalBabbling())])
    explorer = new_explorer(db.Mixture([shared, db.Mixture([shared])]))
    live(explorer, np.random.default_rng(1), 10)
    explorer.save(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run")
    outer, inner = again.strategy.strategies
    assert outer is inner.strategies[0]
    assert everything(again) == everything(explorer)


@pytest.mark.parametrize("kind", ["PCG64", "PCG64DXSM", "MT19937", "Philox", "SFC64"])
def test_every_bit_generator_of_numpy(kind, tmp_path):
    rng = np.random.Generator(getattr(np.random, kind)(5))
    rng.integers(10, dtype=np.uint32)  # leaves half of a number over
    explorer = new_explorer(db.Adapt([db.MotorBabbling(), db.GoalBabbling()]), rng)
    live(explorer, np.random.default_rng(1), 20)
    explorer.save(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run")
    assert everything(again) == everything(explorer)
    assert again.rng.integers(10**9, dtype=np.uint32) == rng.integers(10**9, dtype=np.uint32)


class Learning(db.Strategy):
    """A user's, which learns from all that it is told."""

    def __init__(self):
        self.gains = []

    def propose(self, history, rng):
        space = history.motor_space
        share = rng.random(space.dim) * 0.5 + 0.1 * (len(self.gains) % 5)
        return space.low + (space.high - space.low) * share

    def observe(self, trial, effect):
        self.gains.append(float(effect[0]) + float(trial.command[0]))
        if len(self.gains) == 7:
            raise RuntimeError("the seventh")

    def fail(self, trial, reason):
        del trial
        self.gains.append(float(len(reason)))


def test_a_user_defined_strategy_must_be_given_and_learns_all_again(tmp_path):
    explorer = new_explorer(db.Adapt([Learning(), db.GoalBabbling()]))
    for _ in range(40):
        trial = explorer.ask()
        with suppress(RuntimeError):
            explorer.tell(trial, ARM(trial.command))
    assert len(explorer.strategy.strategies[0].gains) > 7
    explorer.save(tmp_path / "run")
    with pytest.raises(ValueError, match="strategy must be given: the explorer's, Adapt"):
        db.Explorer.load(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run", db.Adapt([Learning(), db.GoalBabbling()]))
    assert again.strategy.strategies[0].gains == explorer.strategy.strategies[0].gains
    assert everything(again) == everything(explorer)


@pytest.mark.parametrize(
    "name", ["bandit by a policy of MABWiser", "evolution, of Optuna", "adapt of other libraries"]
)
def test_what_belongs_to_another_library_must_be_given(name, tmp_path):
    new_explorer(adapted()[name]).save(tmp_path / "run")
    with pytest.raises(ValueError, match="strategy must be given"):
        db.Explorer.load(tmp_path / "run")


def test_a_proposal_that_was_refused_is_made_again(tmp_path):
    class Careless(db.Strategy):
        def propose(self, history, rng):
            command = history.motor_space.sample(rng)
            return 9 * command if command[0] > 2 else command

    explorer = new_explorer(Careless())
    refused = 0
    for _ in range(40):
        try:
            trial = explorer.ask()
        except ValueError:
            refused += 1
        else:
            explorer.tell(trial, ARM(trial.command))
    assert 0 < refused < 40
    explorer.save(tmp_path / "run")
    assert everything(db.Explorer.load(tmp_path / "run", Careless())) == everything(explorer)


def test_no_sensory_space_and_nothing_told(tmp_path):
    for told in (0, 3):
        explorer = db.Explorer(db.MotorBabbling(), ARM.motor_space, rng=0)
        for _ in range(told):
            explorer.tell(explorer.ask(), [1.0, 2.0, 3.0])
        explorer.save(tmp_path / "run")
        again = db.Explorer.load(tmp_path / "run")
        assert again.history.sensory_space is None
        assert everything(again) == everything(explorer)


def test_another_strategy_is_refused(tmp_path):
    explorer = new_explorer(db.GoalBabbling(0.05))
    live(explorer, np.random.default_rng(0), 20)
    explorer.save(tmp_path / "run")
    for other in (db.GoalBabbling(0.06), db.MotorBabbling(), db.Mixture([db.GoalBabbling(0.05)])):
        with pytest.raises(ValueError, match=r"repeats what the saved one, GoalBabbling\(0.05\)"):
            db.Explorer.load(tmp_path / "run", other)
    with pytest.raises(TypeError, match="strategy must be a Strategy, got int"):
        db.Explorer.load(tmp_path / "run", 7)


def test_a_generator_that_others_drew_from_is_refused(tmp_path):
    rng = np.random.default_rng(0)
    explorer = new_explorer(db.MotorBabbling(), rng)
    for _ in range(3):
        explorer.tell(explorer.ask(), [rng.random(), 0.0])
    explorer.save(tmp_path / "run")
    with pytest.raises(ValueError, match="the generator was also drawn from elsewhere"):
        db.Explorer.load(tmp_path / "run")


def test_generators_that_cannot_be_written(tmp_path):
    class Mine(np.random.PCG64):
        pass

    explorer = new_explorer(db.MotorBabbling(), np.random.Generator(Mine(0)))
    with pytest.raises(ValueError, match="rng must be a Generator of one of NumPy's own"):
        explorer.save(tmp_path / "run")
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_pickled(tmp_path):
    explorer = new_explorer(compositions()["adapt of adapts"])
    live(explorer, np.random.default_rng(0), 10)
    explorer.save(tmp_path / "run")
    arrays = 0
    with (tmp_path / "run").open("rb") as file:
        while file.peek():
            arrays += not np.load(file, allow_pickle=False).dtype.hasobject
    assert arrays == 16


def blocks(path):
    """Return the arrays of the two blocks of a file; the words are those of the first."""
    head, rest = (arrays for arrays, _ in unpacked(path.read_bytes()))
    return rest | head


def rewritten(source, target, **changed):
    """Write a file with other arrays in either block."""
    blocks = []
    for arrays, _ in unpacked(source.read_bytes()):
        names = arrays.keys() - ({"words"} if "events" in arrays else set())
        blocks.append(packed({**arrays, **{k: v for k, v in changed.items() if k in names}}))
    target.write_bytes(b"".join(blocks))


DAMAGED = {
    "newer": {"format": lambda _: np.array(["divbandit explorer", "4"])},
    "foreign": {"format": lambda _: np.array(["divbandit exploration", "3"])},
    "an effect less": {"effects": lambda a: a["effects"][:-1]},
    "a command less": {"commands": lambda a: a["commands"][:-1]},
    "an event less": {"events": lambda a: a["events"][:-1]},
    "an unknown event": {"events": lambda a: a["events"] | 7},
    "told twice": {"events": lambda a: np.append(a["events"], a["events"][-1])},
    "negative": {"events": lambda a: -a["events"]},
    "a failure": {"failed": lambda _: np.array([0])},
    "a pending trial": {"pending": lambda _: np.array([0])},
    "no words": {"words": lambda a: a["words"][:-1]},
    "a strategy that is none": {
        "words": lambda a: np.frombuffer(
            a["words"].tobytes().replace(b"goal_babbling.GoalBabbling", b"base.Trial"), np.uint8
        )
    },
    "a strategy from elsewhere": {
        "words": lambda a: np.frombuffer(
            a["words"].tobytes().replace(b"strategies.goal_babbling.GoalBabbling", b"os.system"),
            np.uint8,
        )
    },
    "a command that is no number": {"commands": lambda a: a["commands"] * np.nan},
    "another effect": {"effects": lambda a: a["effects"][:, :1]},
}


@pytest.mark.parametrize("damage", DAMAGED.values(), ids=DAMAGED)
def test_damaged_files_are_refused(damage, tmp_path):
    explorer = new_explorer(db.GoalBabbling(0.05))
    for _ in range(10):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    explorer.save(tmp_path / "run")
    arrays = blocks(tmp_path / "run")
    rewritten(tmp_path / "run", tmp_path / "bad", **{name: f(arrays) for name, f in damage.items()})
    with pytest.raises(ValueError, match=r"^(path must be a file written by|strategy must be one)"):
        db.Explorer.load(tmp_path / "bad")


def test_truncated_and_foreign_files_are_refused(tmp_path):
    explorer = new_explorer(db.GoalBabbling(0.05))
    live(explorer, np.random.default_rng(0), 10)
    explorer.save(tmp_path / "run")
    whole = (tmp_path / "run").read_bytes()
    (tmp_path / "text").write_text("hello")
    explorer.result().save(tmp_path / "exploration")
    for length in (0, 1, 100, len(whole) // 2, len(whole) - 1):
        (tmp_path / "part").write_bytes(whole[:length])
        with pytest.raises(ValueError, match=r"path must be a file written by Explorer\.save"):
            db.Explorer.load(tmp_path / "part")
    for name in ("text", "exploration"):
        with pytest.raises(ValueError, match=r"path must be a file written by Explorer\.save"):
            db.Explorer.load(tmp_path / name)


def test_an_interrupted_observation_is_no_obstacle(tmp_path):
    class Interrupted(db.Strategy):
        seen = 0

        def propose(self, history, rng):
            return history.motor_space.sample(rng)

        def observe(self, trial, effect):
            del trial, effect
            self.seen += 1
            if self.seen == 3 and interrupting:
                raise KeyboardInterrupt

    interrupting = True
    explorer = new_explorer(db.Mixture([Interrupted()]))
    for step in range(8):
        trial = explorer.ask()
        if step == 2:
            with pytest.raises(KeyboardInterrupt):
                explorer.tell(trial, ARM(trial.command))
        else:
            explorer.tell(trial, ARM(trial.command))
    explorer.save(tmp_path / "run")
    interrupting = False
    again = db.Explorer.load(tmp_path / "run", db.Mixture([Interrupted()]))
    assert everything(again) == everything(explorer)


def test_an_interrupted_proposal_that_drew_nothing_is_no_obstacle(tmp_path):
    class Interrupted(db.Strategy):
        def propose(self, history, rng):
            if interrupting:
                raise KeyboardInterrupt
            return history.motor_space.sample(rng)

    interrupting = False
    explorer = new_explorer(Interrupted())
    explorer.tell(explorer.ask(), [0.5, 0.5])
    interrupting = True
    for call in (explorer.ask, lambda: explorer.ask(3)):
        with pytest.raises(KeyboardInterrupt):
            call()
    interrupting = False
    explorer.tell(explorer.ask(), [0.5, 0.25])
    explorer.save(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run", Interrupted())
    assert everything(again) == everything(explorer)


def test_nothing_left_to_do_is_fine():
    """A script that is started again after its end makes ``n - explorer.evaluations`` trials."""
    explorer = db.Explorer(db.MotorBabbling(), ARM.motor_space, ARM.sensory_space, rng=0)
    explorer.run(ARM, 20)
    assert len(explorer.run(ARM, 20 - explorer.evaluations)) == 20
    with pytest.raises(ValueError, match="n must be at least 0, got -1"):
        explorer.run(ARM, -1)
