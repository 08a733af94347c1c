"""A damaged file is refused with a ValueError that names it, or gives the very same exploration."""

import io
import zipfile

import numpy as np
import pytest

import divbandit as db
from tests.exploration.files import refused
from tests.files import npz, outcome


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
