"""Golden traces: explorations that must come out the same in every version, on every machine."""
