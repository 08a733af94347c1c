"""What is kept of a run: SHA-256 digests of its arrays as little-endian bytes."""

import hashlib

#: The arrays of a run, by what the traces call them: `estimates` were once `diversities`.
NAMES = {"commands": "commands", "effects": "effects", "paths": "paths", "diversities": "estimates"}


def digest(run, following):
    """Return the shape and the digest of each array, and the draw that followed, for JSON."""
    arrays = {name: getattr(run, attribute) for name, attribute in NAMES.items()}
    kept = {name: None if array is None else _of(array) for name, array in arrays.items()}
    return {**kept, "next draw": following.hex()}


def _of(array):
    little_endian = array.astype(array.dtype.newbyteorder("<"), order="C")
    sha = hashlib.sha256(little_endian.tobytes()).hexdigest()
    return f"{array.dtype.name} {'x'.join(map(str, array.shape))} {sha}"
