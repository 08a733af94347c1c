"""Durations."""
def seconds(name: str, value: str) -> float:
    number = value.rstrip("smin hd")
    unit = value[len(number):].strip()
    return float(number) * {"s": 1, "min": 60, "h": 3600, "ms": 0.001, "d": 86400}[unit]
