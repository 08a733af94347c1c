"""What is kept of a run: SHA-256 digests of its arrays as little-endian bytes."""

import hashlib

NAMES = ("commands", "effects", "paths", "diversities")


def digest(run, following):
    """Return the shape and the digest of each array, and the draw that followed, for JSON."""
    arrays = {name: getattr(run, name) for name in NAMES}
    kept = {name: None if array is None else _of(array) for name, array in arrays.items()}
    return {**kept, "next draw": following.hex()}


def _of(array):
    little_endian = array.astype(array.dtype.newbyteorder("<"), order="C")
    sha = hashlib.sha256(little_endian.tobytes()).hexdigest()
    return f"{array.dtype.name} {'x'.join(map(str, array.shape))} {sha}"
