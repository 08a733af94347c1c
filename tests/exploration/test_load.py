"""What is no saved exploration is refused with a ValueError that says so, whatever it is."""

import io
import pickle

import numpy as np
import pytest

import divbandit as db
from tests.exploration.files import refused
from tests.files import edited, npz


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
    refused(tmp_path / "run", content)


def test_a_plain_npy(tmp_path):
    file = io.BytesIO()
    np.save(file, np.zeros((3, 2)))
    refused(tmp_path / "run", file.getvalue())


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
