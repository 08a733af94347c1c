"""Saved, pickled and copied coverages go on exactly alike; anything else is refused by name."""

import pickle
from functools import partial

import numpy as np
import pytest

import divbandit as db
from tests import files
from tests.measures.every import COPIES, clustered

DIMS = [1, 2, 3, 5]
every = pytest.mark.parametrize("dim", DIMS)
refused = partial(files.refused, db.Coverage.load)


class Named(db.Coverage):
    """A coverage of one's own: found by its name when it is unpickled."""

    def doubled(self):
        return 2 * self.measure


def filled(dim, n=60, cls=db.Coverage):
    cov = cls(0.4, dim=dim, accuracy=0.02, rng=3)
    cov.extend(clustered(dim, n))
    return cov


def saved_and_loaded(cov, folder):
    cov.save(folder / "cov")
    return type(cov).load(folder / "cov")


def seen(cov):
    """Return all there is to see, bit for bit."""
    numbers = (cov.tau, cov.dim, cov.exact, cov.accuracy, cov.measure, cov.standard_error)
    arrays = (cov.effects, cov.gains, cov.standard_errors)
    return len(cov), numbers, [array.tobytes() for array in arrays], repr(cov)


def same_from_here(one, other):
    """Check that two are alike, and stay so: what either would gain, loses and goes on to be."""
    assert type(one) is type(other)
    assert seen(one) == seen(other)
    more = clustered(one.dim, 40, seed=8) * 1.5
    assert np.array_equal(one.contains(more), other.contains(more))
    for index in range(0, len(one), 9):
        asked = [cov.contribution(index, with_error=True) for cov in (one, other)]
        assert asked[0] == asked[1]
    assert np.array_equal(one.gain(more, with_error=True), other.gain(more, with_error=True))
    assert one.extend(more).tolist() == other.extend(more).tolist()
    assert seen(one) == seen(other)


@every
@pytest.mark.parametrize("n", [0, 1, 200])
def test_a_saved_one_goes_on_alike(dim, n, tmp_path):
    cov = filled(dim, n) if n > 1 else db.Coverage(0.4, dim=dim, accuracy=0.02, rng=3)
    if n == 1:
        cov.add(np.zeros(dim))
    same_from_here(saved_and_loaded(cov, tmp_path), cov)


@every
@pytest.mark.parametrize("way", COPIES)
def test_a_copied_or_pickled_one_goes_on_alike(dim, way):
    cov = filled(dim)
    same_from_here(COPIES[way](cov), cov)


@every
@pytest.mark.parametrize("protocol", range(2, pickle.HIGHEST_PROTOCOL + 1))
def test_every_protocol_of_pickling(dim, protocol):
    cov = filled(dim)
    same_from_here(pickle.loads(pickle.dumps(cov, protocol)), cov)  # noqa: S301


@every
def test_saved_again_and_again_halfway(dim, tmp_path):
    """Through a file and a pickle after every few effects, as if nothing had happened."""
    points = clustered(dim, 60)
    straight = db.Coverage(0.4, dim=dim, accuracy=0.02, rng=3)
    halting = db.Coverage(0.4, dim=dim, accuracy=0.02, rng=3)
    for some in np.array_split(points, 6):
        straight.extend(some)
        halting.extend(some)
        halting = COPIES["pickle"](saved_and_loaded(halting, tmp_path))
    same_from_here(halting, straight)


@pytest.mark.parametrize("dim", [1, 2, 3])
def test_lattices_with_exact_tangencies_are_restored(dim):
    grid = np.stack(np.meshgrid(*[np.arange(4)] * dim), axis=-1).reshape(-1, dim)
    for tau in (0.5, 1.0, 0.75):
        cov = db.Coverage(tau, dim=dim)
        cov.extend(np.random.default_rng(dim).permutation(grid))
        same_from_here(COPIES["pickle"](cov), cov)


@every
@pytest.mark.parametrize("way", [*COPIES, "file"])
def test_a_subclass_stays_what_it_is(dim, way, tmp_path):
    cov = filled(dim, cls=Named)
    other = saved_and_loaded(cov, tmp_path) if way == "file" else COPIES[way](cov)
    assert other.doubled() == 2 * cov.measure
    same_from_here(other, cov)


@pytest.mark.parametrize("version", [0, 2, "1", None])
def test_a_pickle_of_another_version_is_refused(version):
    build, (cls, _, log) = filled(2).__reduce__()
    with pytest.raises(ValueError, match=rf"must have version 1, got {version!r}"):
        build(cls, version, log)


@every
def test_nothing_in_a_file_is_pickled(dim, tmp_path):
    filled(dim).save(tmp_path / "cov")
    with np.load(tmp_path / "cov", allow_pickle=False) as file:
        assert all(file[name].dtype != object for name in file.files)


@pytest.fixture(scope="module", params=DIMS)
def saved(request, tmp_path_factory):
    """Return the dimension, and the bytes of a saved coverage."""
    path = tmp_path_factory.mktemp("saved") / "cov"
    filled(request.param, 30).save(path)
    return request.param, path.read_bytes()


@pytest.mark.parametrize("flipped", [0xFF, 0x01, 0x10])
def test_damaged_bytes_are_refused_or_harmless(flipped, saved, tmp_path):
    path, content = tmp_path / "cov", saved[1]
    path.write_bytes(content)
    intact, outcomes = seen(db.Coverage.load(path)), {}
    directory = content.index(b"PK\x01\x02")
    for position in [*range(0, directory, 7), *range(directory, len(content), 3)]:
        damaged = bytearray(content)
        damaged[position] ^= flipped
        came = files.outcome(db.Coverage.load, path, damaged, lambda cov: seen(cov) == intact)
        outcomes.setdefault(came, position)
    assert set(outcomes) <= {"refused", "harmless"}, outcomes


def test_what_others_wrote(tmp_path):
    path = tmp_path / "cov"
    refused(path, b"hello")
    refused(path, pickle.dumps(filled(2)))
    assert "does not say its format" in refused(path, files.npz(gains=np.zeros(3)))
    db.explore(db.PlanarArm(2), db.MotorBabbling(), n=3, rng=0).save(path)
    assert "format must be 'divbandit coverage' 1" in refused(path, path.read_bytes())
    filled(2).save(path)
    content = files.edited(path.read_bytes(), format=np.array(["divbandit coverage", "2"]))
    assert "format must be" in refused(path, content)


@every
def test_arrays_that_do_not_fit(dim, tmp_path):
    cov, path = filled(dim, 30), tmp_path / "cov"
    cov.save(path)
    content, gains, errors = path.read_bytes(), cov.gains, cov.standard_errors
    ball, bad_first = cov.largest_gain, np.arange(30) == 0
    wrong = {
        "effects": [None, cov.effects[:-1], cov.effects[:, :-1], cov.effects.astype(np.float32)],
        "gains": [None, gains[1:], -gains, gains[:, None], np.where(bad_first, 1.01 * ball, gains)],
        "standard_errors": [None, errors[1:], -1 - errors, np.full(30, np.nan), np.full(30, 9e9)],
        "ball": [np.array([0.0, 0.02]), np.array([0.4, 1.0]), np.array([np.nan, 0.02]), gains[:1]],
        "dim_and_key": [np.array(pair) for pair in ([0, 1], [40, 1], [dim + 1, 1], [dim, -1])],
    }
    wrong["effects"].append(np.where(cov.effects > 0, np.inf, cov.effects))
    wrong["gains"] += [np.where(bad_first, bad, gains) for bad in (np.nan, np.inf, -1e-300)]
    for name, values in wrong.items():
        for value in values:
            refused(path, files.edited(content, **{name: value}))


@every
def test_tampered_gains(dim, tmp_path):
    """Found out where all is computed anew; where that is dear, nothing beyond a ball passes."""
    cov, path = filled(dim, 30), tmp_path / "cov"
    cov.save(path)
    tampered = cov.gains.copy()
    tampered[np.argmax(tampered)] *= 1 - 2.0**-52
    content = files.edited(path.read_bytes(), gains=tampered)
    if dim <= 2:
        assert "what its effect gains" in refused(path, content)
    else:
        path.write_bytes(content)
        assert db.Coverage.load(path).gains.tolist() == tampered.tolist()


def test_what_cannot_be_read_or_written_is_an_os_error(tmp_path):
    with pytest.raises(FileNotFoundError, match="missing"):
        db.Coverage.load(tmp_path / "missing")
    with pytest.raises(OSError, match="no folder"):
        filled(2).save(tmp_path / "no folder" / "cov")
    assert [*tmp_path.iterdir()] == []
