"""Comparing pictures: exactly, and with something to look at when they differ."""

from pathlib import Path

import numpy as np

from bgi.memory.imagefile import load, save
from bgi.memory.rgb import SIXTEEN

FAILED = Path(__file__).parent / "failed"
_COLORS = np.array(SIXTEEN * 16, dtype=np.uint8)


def read_indices(path):
    """The palette indices of a PNG, shape (height, width)."""
    return load(path).pixels


def points(screen):
    """The pixels that are set on the active page, as a set of (x, y)."""
    ys, xs = screen.page.array.nonzero()
    return set(zip(xs.tolist(), ys.tolist(), strict=True))


def assert_same(got, expected, name):
    """Fail unless two arrays of indices are equal; then write got, expected and difference."""
    assert got.shape == expected.shape
    wrong = np.argwhere(got != expected)
    if not len(wrong):
        return
    FAILED.mkdir(exist_ok=True)
    gap = np.full((got.shape[0], 4), 8, dtype=np.uint8)
    difference = np.where(got != expected, np.uint8(12), np.uint8(0))
    save(FAILED / f"{name}.png", np.hstack([got, gap, expected, gap, difference]), _COLORS)
    (top, left), (bottom, right) = wrong.min(axis=0), wrong.max(axis=0)
    first = ", ".join(
        f"({x}, {y}): {got[y, x]} for {expected[y, x]}" for y, x in wrong[:5].tolist()
    )
    raise AssertionError(
        f"{name}: {len(wrong)} pixels differ within ({left}, {top})-({right}, {bottom});"
        f" {first}; see {FAILED / name}.png (got, expected, difference)"
    )


def picture(rows):
    """An array of indices drawn with characters: `.` is 0, other digits themselves."""
    lines = rows.split()
    return np.array([[0 if c == "." else int(c, 16) for c in line] for line in lines], np.uint8)
