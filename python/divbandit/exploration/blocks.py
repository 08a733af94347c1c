"""Blocks: files of arrays that grow, block by block, and show what is damaged or missing.

A file is a sequence of arrays in NumPy's format, which ``numpy.load`` reads one by one from an open
file. Each block begins with three numbers: how many bytes follow, their checksum, and a checksum of
these two; then come the names of its arrays, as JSON, and the arrays.
"""

from __future__ import annotations

import io
import zlib
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.lib.format import dtype_to_descr, read_array, write_array_header_1_0

from divbandit._files import from_json, to_json

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from numpy.typing import NDArray


def packed(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """Return a block.

    Examples
    --------
    >>> block = packed({"effects": np.ones(2)})
    >>> [(arrays["effects"].tolist(), end == len(block)) for arrays, end in unpacked(block)]
    [([1.0, 1.0], True)]
    """
    # Copied once alone: there may be many, and they may be large.
    body = _parts(from_json(list(arrays)), *arrays.values())
    checksum = 0
    for part in body:
        checksum = zlib.crc32(part, checksum)
    length = np.array([sum(part.nbytes for part in body), checksum], dtype=np.uint64)
    head = _parts(np.append(length, np.uint64(zlib.crc32(length.tobytes()))))
    return b"".join(head + body)


def unpacked(data: bytes) -> Iterator[tuple[dict[str, NDArray[Any]], int]]:
    """Return each complete block's arrays, and where it ends.

    A damaged block raises a ValueError.
    """
    view, start, head = memoryview(data), 0, len(b"".join(_parts(np.zeros(3, dtype=np.uint64))))
    while start + head <= len(data):
        length = read_array(io.BytesIO(view[start : start + head]), allow_pickle=False)
        if length.shape != (3,) or length.dtype != np.uint64:
            raise ValueError("a block must begin with its length")
        if zlib.crc32(length[:2].tobytes()) != length[2]:
            raise ValueError("the length of a block is damaged")
        start, end = start + head, start + head + int(length[0])
        if end > len(data):
            return
        body = view[start:end]
        if zlib.crc32(body) != length[1]:
            raise ValueError("a block is damaged")
        file = io.BytesIO(body)
        names = to_json({"names": read_array(file, allow_pickle=False)}, "names")
        yield {name: read_array(file, allow_pickle=False) for name in names}, end
        start = end


def _parts(*arrays: NDArray[Any]) -> list[memoryview]:
    """Return arrays as NumPy writes them, in parts."""
    parts = []
    for array in map(np.ascontiguousarray, arrays):
        parts += [memoryview(_header(array.dtype, array.shape)), array.data]
    return parts


@lru_cache
def _header(dtype: np.dtype[Any], shape: tuple[int, ...]) -> bytes:
    """Return what precedes an array's numbers; NumPy takes longer for it than for these."""
    file = io.BytesIO()
    words = {"descr": dtype_to_descr(dtype), "fortran_order": False, "shape": shape}
    write_array_header_1_0(file, words)
    return file.getvalue()
