"""Optional libraries: what is imported is imported whole."""

import signal
import sys

import pytest

from divbandit._library import library

#: A package whose import takes a Ctrl-C on the way.
PACKAGE = """
import os, signal
os.kill(os.getpid(), signal.SIGINT)
sum(range(10**6))
whole = True
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT for a process")
def test_ctrl_c_waits_until_a_library_is_imported(tmp_path, monkeypatch):
    """What was imported in part could not be imported again: loky would lack its `backend`."""
    (tmp_path / "interrupted_library.py").write_text(PACKAGE, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    usual = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            library("interrupted_library", user="a test")
    finally:
        signal.signal(signal.SIGINT, usual)
    assert sys.modules.pop("interrupted_library").whole
