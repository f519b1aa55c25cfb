"""Measurements: `python -m bench` prints every budgeted call in multiples of an empty call."""
