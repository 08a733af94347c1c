"""What is no saved exploration is refused with a ValueError that says so, whatever it is.

A damaged file may also give the very same exploration; files of the first format are read.
"""

import io
import pickle
import zipfile
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import divbandit as db
from tests import files
from tests.files import edited, npz, outcome

ARM = db.PlanarArm(3)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.1, window=5)
#: Files of the first format: an exploration of 12 steps, and an explorer that was told 5; `rng=0`.
FOLDER = Path(__file__).parent / "earlier"

refused = partial(files.refused, db.Exploration.load)


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """Return the bytes of a saved exploration."""
    path = tmp_path_factory.mktemp("saved") / "run"
    db.explore(ARM, ADAPT, n=30, rng=0).save(path)
    return path.read_bytes()


def test_pickles_are_not_opened(tmp_path):
    class Bomb:
        def __reduce__(self):
            return pytest.fail, ("a pickle was opened",)

    refused(tmp_path / "run", pickle.dumps(Bomb()))
    refused(tmp_path / "run", npz(format=np.array([Bomb()], dtype=object)))


@pytest.mark.parametrize(
    "content", [npz(), npz(a=np.zeros(3)), npz(commands=np.zeros((3, 2)), effects=np.zeros((3, 2)))]
)
def test_a_foreign_npz(content, tmp_path):
    assert "it does not say its format" in refused(tmp_path / "run", content)


def test_what_is_no_npz(tmp_path):
    file = io.BytesIO()
    np.save(file, np.zeros((3, 2)))
    for content in (file.getvalue(), b"hello"):
        message = refused(tmp_path / "run", content)
        assert "it is another file, or a part of one" in message
        assert "allow_pickle" not in message


@pytest.mark.parametrize(
    "changes",
    [
        {"format": np.array(["divbandit exploration", "3"])},
        {"format": np.array(["divbandit exploration", "x"])},
        {"format": np.array(["something else", "2"])},
        {"format": np.array("divbandit exploration")},
        {"commands": None},
        {"effects": None},
        {"paths": None},
        {"motor_space": None},
        {"commands": np.zeros((30, 4))},
        {"commands": np.zeros((30, 3), dtype=np.float32)},
        {"effects": np.zeros((29, 2))},
        {"effects": np.zeros((30, 3))},
        {"effects": np.zeros(30)},
        {"paths": np.zeros((29, 1), dtype=np.int64)},
        {"paths": np.zeros((30, 1))},
        {"estimates": np.zeros((31, 2))},
        {"motor_space": np.array([[1.0, 1, 1], [0, 0, 0]])},
        {"motor_space": np.full((2, 3), np.nan)},
        {"motor_space": np.zeros((3, 3))},
        {"sensory_space": np.zeros((2, 3))},
    ],
    ids="-".join,
)
def test_arrays_that_do_not_fit(changes, saved, tmp_path):
    refused(tmp_path / "run", edited(saved, **changes))


def test_a_rewritten_file_that_fits_is_accepted(saved, tmp_path):
    (tmp_path / "run").write_bytes(edited(saved))
    assert len(db.Exploration.load(tmp_path / "run")) == 30


def test_a_missing_file_is_an_os_error(tmp_path):
    with pytest.raises(FileNotFoundError):
        db.Exploration.load(tmp_path / "run")
    with pytest.raises(OSError, match="directory"):
        db.Exploration.load(tmp_path)


@pytest.mark.parametrize("share", [0, 0.001, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 0.999])
def test_truncated(share, saved, tmp_path):
    refused(tmp_path / "run", saved[: int(share * len(saved))])


def test_truncated_by_a_byte(saved, tmp_path):
    refused(tmp_path / "run", saved[:-1])


@pytest.mark.parametrize("length", [1, 4, 100, 10_000])
@pytest.mark.parametrize("magic", [b"", b"PK\x03\x04", b"\x93NUMPY\x01\x00", b"\x80\x04"])
def test_random_bytes(length, magic, tmp_path):
    refused(tmp_path / "run", magic + np.random.default_rng(length).bytes(length))


@pytest.mark.parametrize("flipped", [0xFF, 0x01, 0x04, 0x06, 0x10])
def test_damaged_bytes_are_refused_or_harmless(flipped, saved, tmp_path):
    """Bytes flipped one at a time: each of the directory at the end, and some before it."""
    path = tmp_path / "run"
    path.write_bytes(saved)
    intact = db.Exploration.load(path)

    def is_same(run):
        return all(
            np.array_equal(getattr(run, name), getattr(intact, name))
            for name in ("commands", "effects", "paths", "estimates")
        )

    directory = saved.index(b"PK\x01\x02")
    outcomes = {}
    for position in [*range(0, directory, 11), *range(directory, len(saved))]:
        damaged = bytearray(saved)
        damaged[position] ^= flipped
        outcomes.setdefault(outcome(db.Exploration.load, path, damaged, is_same), position)
    assert set(outcomes) <= {"refused", "harmless"}, outcomes


def test_an_array_that_claims_to_be_larger_than_memory(saved, tmp_path):
    content = io.BytesIO(saved)
    header = io.BytesIO()
    claim = {"descr": "<f8", "fortran_order": False, "shape": (10**14, 3)}
    np.lib.format.write_array_header_1_0(header, claim)
    with np.load(content) as file:
        arrays = dict(file.items())
    del arrays["commands"]
    content = io.BytesIO(npz(**arrays))
    with zipfile.ZipFile(content, "a") as archive:
        archive.writestr("commands.npy", header.getvalue())
    refused(tmp_path / "run", content.getvalue())


def test_an_exploration_is_read():
    run, again = (
        db.Exploration.load(FOLDER / "exploration_1.npz"),
        db.explore(ARM, ADAPT, n=12, rng=0),
    )
    for name in ("commands", "effects", "paths", "estimates"):
        assert (getattr(run, name) == getattr(again, name)).all()


def test_an_explorer_is_refused_with_a_way_to_go_on():
    with pytest.raises(ValueError, match="past="):
        db.Explorer.load(FOLDER / "explorer_1.npz")


def test_the_way_to_go_on():
    with np.load(FOLDER / "explorer_1.npz") as arrays:
        commands, effects = arrays["commands"], arrays["effects"]
    explorer = db.Explorer(ADAPT, ARM.motor_space, ARM.sensory_space, rng=0)
    explorer.add_past(commands, effects)
    assert (explorer.history.effects == db.explore(ARM, ADAPT, n=5, rng=0).effects).all()
    explorer.tell(trial := explorer.ask(), ARM(trial.command))
    assert len(explorer.history) == 6
