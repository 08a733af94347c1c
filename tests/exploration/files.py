"""Files that are no saved explorations, and what must come of loading them."""

import io
import re

import numpy as np
import pytest

import divbandit as db


def refused(path, content):
    """Write `content` to a file and check that it is refused."""
    path.write_bytes(content)
    named = r"path must be .*" + re.escape(repr(str(path)))
    with pytest.raises(ValueError, match=named):
        db.Exploration.load(path)


def npz(**arrays):
    file = io.BytesIO()
    np.savez(file, **arrays)
    return file.getvalue()


def edited(saved, **changes):
    """Return a saved exploration with some arrays replaced, or left out if None."""
    with np.load(io.BytesIO(saved)) as file:
        arrays = dict(file.items()) | changes
    return npz(**{name: array for name, array in arrays.items() if array is not None})
