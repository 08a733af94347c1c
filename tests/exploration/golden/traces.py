"""The file of the golden traces, traces.json."""

import json
from pathlib import Path

FILE = Path(__file__).with_name("traces.json")


def read():
    """Return the digests that were kept, by configuration."""
    return json.loads(FILE.read_text(encoding="utf-8"))


def write(digests):
    """Keep digests in place of those before."""
    FILE.write_text(json.dumps(digests, indent=1) + "\n", encoding="utf-8")
