"""An exploration that was saved and loaded is the same, and a failed save harms nothing."""

import os
import stat
import sys

import numpy as np
import pytest

import divbandit as db
from tests.compositions import NAMES, compositions

ARM = db.PlanarArm(4)


def bits(run):
    estimates = None if run.estimates is None else run.estimates.tobytes()
    return (
        run.commands.tobytes(),
        run.effects.tobytes(),
        run.paths.tobytes(),
        run.paths.shape,
        estimates,
        run.motor_space,
        run.sensory_space,
    )


def make_run(rng=0, n=40):
    return db.explore(ARM, compositions()["adapt of adapts"], n=n, rng=rng)


@pytest.mark.parametrize("name", NAMES)
def test_loaded_is_saved(name, tmp_path):
    run = db.explore(ARM, compositions()[name], n=40, rng=0)
    run.save(tmp_path / "run")
    again = db.Exploration.load(tmp_path / "run")
    assert bits(again) == bits(run)
    assert again.choices.tolist() == run.choices.tolist()
    assert again.coverage(0.02).tolist() == run.coverage(0.02).tolist()


@pytest.mark.parametrize("s", [1, 3])
def test_an_environment_without_a_sensory_space(s, tmp_path):
    environment = db.FunctionEnvironment(lambda x: x[:s], ARM.motor_space)
    run = db.explore(environment, db.MotorBabbling(), n=5, rng=0)
    run.save(tmp_path / "run")
    again = db.Exploration.load(tmp_path / "run")
    assert again.sensory_space is None
    assert bits(again) == bits(run)


def test_nothing_told_yet(tmp_path):
    run = db.Explorer(db.MotorBabbling(), ARM.motor_space, ARM.sensory_space).result()
    run.save(tmp_path / "run")
    assert bits(db.Exploration.load(tmp_path / "run")) == bits(run)


def test_nothing_is_pickled(tmp_path):
    make_run().save(tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz", allow_pickle=False) as saved:
        arrays = dict(saved.items())
    assert {"commands", "effects", "paths", "estimates", "motor_space"} <= set(arrays)
    assert not any(array.dtype.hasobject for array in arrays.values())


def test_the_same_run_gives_the_same_file(tmp_path):
    for name in ("a", "b"):
        make_run().save(tmp_path / name)
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()


def test_saving_again_replaces(tmp_path):
    path = tmp_path / "run"
    make_run(rng=0, n=200).save(path)
    make_run(rng=1).save(path)
    assert bits(db.Exploration.load(path)) == bits(make_run(rng=1))
    assert [file.name for file in tmp_path.iterdir()] == ["run"]


@pytest.mark.parametrize("error", [OSError("disk full"), KeyboardInterrupt(), MemoryError()])
def test_a_failed_save_leaves_the_old_file_and_nothing_else(error, tmp_path, monkeypatch):
    path = tmp_path / "run"
    make_run(rng=0).save(path)
    before = path.read_bytes()

    def fail(file, **arrays):
        del arrays
        file.write(b"half of it")
        raise error

    monkeypatch.setattr(np, "savez_compressed", fail)
    with pytest.raises(type(error)):
        make_run(rng=1).save(path)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["run"]


def test_a_folder_that_does_not_exist(tmp_path):
    with pytest.raises(OSError, match="nowhere"):
        make_run().save(tmp_path / "nowhere" / "run")
    assert list(tmp_path.iterdir()) == []


def test_a_folder_in_the_place_of_the_file(tmp_path):
    (tmp_path / "run").mkdir()
    with pytest.raises(OSError, match="run"):
        make_run().save(tmp_path / "run")
    assert [file.name for file in tmp_path.iterdir()] == ["run"]


@pytest.mark.skipif(sys.platform == "win32", reason="permission bits are POSIX's")
@pytest.mark.parametrize("umask", [0o022, 0o027])
def test_a_saved_file_can_be_read_by_whom_any_new_file_can(umask, tmp_path):
    old = os.umask(umask)
    try:
        (tmp_path / "plain").write_bytes(b"")
        make_run().save(tmp_path / "run")
    finally:
        os.umask(old)
    modes = [stat.S_IMODE((tmp_path / name).stat().st_mode) for name in ("plain", "run")]
    assert modes[1] == modes[0]
