"""Files that are not what was saved, and what must come of loading them."""

import io
import re

import numpy as np
import pytest


def refused(load, path, content):
    """Write `content` to a file and check that it is refused; return what the error says."""
    path.write_bytes(content)
    named = r"path must be .*" + re.escape(repr(str(path)))
    with pytest.raises(ValueError, match=named) as caught:
        load(path)
    return str(caught.value)


def outcome(load, path, content, is_same):
    """Return what comes of loading `content`: refused, harmless, or what must not happen."""
    path.write_bytes(content)
    try:
        loaded = load(path)
    except ValueError as error:
        return "refused" if str(path) in str(error) else f"unnamed: {error}"
    except Exception as error:  # noqa: BLE001 - whatever it is, it is reported
        return repr(error)
    return "harmless" if is_same(loaded) else "changed"


def npz(**arrays):
    file = io.BytesIO()
    np.savez(file, **arrays)
    return file.getvalue()


def edited(saved, **changes):
    """Return what was saved with some arrays replaced, or left out if None."""
    with np.load(io.BytesIO(saved)) as file:
        arrays = dict(file.items()) | changes
    return npz(**{name: array for name, array in arrays.items() if array is not None})
