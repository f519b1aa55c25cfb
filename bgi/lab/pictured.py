"""The screen as it is, compared with a picture in a file."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bgi import current
from bgi.lab.comparison import side_by_side
from bgi.lab.verdict import Verdict
from bgi.memory.image import Image
from bgi.memory.imagefile import load
from bgi.memory.matching import nearest, shown
from bgi.memory.rgb import SIXTEEN

Colors = NDArray[np.uint8]
"""Red, green and blue of every pixel."""

FARTHEST = 12
"""Pixels by which a picture may be shifted to be called that."""
FEW = 100
"""So many wrong pixels are few."""
_PALETTE = np.array(SIXTEEN, np.uint8)


def compare(file: str | os.PathLike[str]) -> Verdict:
    """What the active page looks like, against the file."""
    screen = current.screen
    expected = load(file).rgba[..., :3]
    got = shown(screen.page.array, screen.card.palette)
    name = Path(file).name
    if got.shape != expected.shape:
        ours, theirs = (f"{one.shape[1]}x{one.shape[0]}" for one in (got, expected))
        reason = f"the screen has {ours}, {name} has {theirs} pixels"
        return Verdict("picture", False, 1, 0, reason, "open the screen in the same mode")
    wrong = (got != expected).any(axis=2)
    if not wrong.any():
        return Verdict("picture", True, 1, 1)
    y, x = np.argwhere(wrong)[0].tolist()
    reason = f"{int(wrong.sum()):,} of {wrong.size:,} pixels are not as in {name}: first {x}, {y}"
    hint = next((words for seems, words in SIGNS if seems(got, expected)), "")
    hint = _shifted(got, expected) or hint
    return Verdict("picture", False, 1, 0, reason, hint, _image(got, expected))


def _image(got: Colors, expected: Colors) -> Image | None:
    """Both in the nearest of sixteen colours, as far as they differ in those."""
    one, other = (_indices(picture) for picture in (got, expected))
    return side_by_side(one, other, np.zeros_like(one)) if (one != other).any() else None


def _indices(picture: Colors) -> Colors:
    found = nearest(picture.reshape(-1, 3), _PALETTE).astype(np.uint8)
    return found.reshape(picture.shape[:2])


def _forms(picture: Colors) -> NDArray[np.bool_]:
    """Where something is drawn: what is not of the colour that most pixels have."""
    numbers = picture.astype(np.int64) @ (1 << 16, 1 << 8, 1)
    values, counts = np.unique(numbers, return_counts=True)
    forms: NDArray[np.bool_] = numbers != values[counts.argmax()]
    return forms


def _recolored(got: Colors, expected: Colors) -> bool:
    return bool(np.array_equal(_forms(got), _forms(expected))) and bool(_forms(got).any())


def _lacking(got: Colors, expected: Colors) -> bool:
    """Everything that is there is right."""
    drawn = _forms(got)
    return bool((got[drawn] == expected[drawn]).all())


def _more(got: Colors, expected: Colors) -> bool:
    wanted = _forms(expected)
    return bool((got[wanted] == expected[wanted]).all())


def _ground(got: Colors, expected: Colors) -> bool:
    """Only what is drawn is right, and the background has another colour."""
    forms = _forms(expected)
    return np.array_equal(_forms(got), forms) and bool((got[forms] == expected[forms]).all())


def _transposed(got: Colors, expected: Colors) -> bool:
    """x and y are exchanged, as far as both are on the screen."""
    side = min(got.shape[:2])
    ours, theirs = _forms(got)[:side, :side], _forms(expected)[:side, :side]
    return int((ours ^ theirs.T).sum()) <= int(theirs.sum()) // 20


def _outlined(got: Colors, expected: Colors) -> bool:
    """Of each form only the rim is there."""
    ours, theirs = _forms(got), _forms(expected)
    inner = theirs.copy()
    inner[1:-1, 1:-1] &= theirs[:-2, 1:-1] & theirs[2:, 1:-1] & theirs[1:-1, :-2] & theirs[1:-1, 2:]
    rims_only = not (ours & ~theirs).any() and not (theirs & ~inner & ~ours).any()
    return rims_only and 10 * int((ours & inner).sum()) < int(inner.sum())


def _few(got: Colors, expected: Colors) -> bool:
    return int((got != expected).any(axis=2).sum()) <= FEW


def _turned(change: Callable[[Colors], Colors]) -> Callable[[Colors, Colors], bool]:
    return lambda got, expected: np.array_equal(change(got), expected)


SIGNS: list[tuple[Callable[[Colors, Colors], bool], str]] = [
    (lambda got, expected: not _forms(got).any(), "nothing is drawn yet"),
    (_turned(lambda picture: picture[::-1]), "it is upside down: y grows downwards"),
    (_turned(lambda picture: picture[:, ::-1]), "left and right are exchanged"),
    (_transposed, "x and y are exchanged: x goes to the right and stands first, y goes down"),
    (_ground, "the background has another colour, all else is right"),
    (_recolored, "the forms are right, colours are not"),
    (_outlined, "only the rims are there: areas are filled"),
    (_lacking, "what is there is right: something is missing"),
    (_more, "all that is wanted is there, and something more"),
    (_few, "only a few pixels are wrong: where does a loop begin, and where does it end?"),
]


def _shifted(got: Colors, expected: Colors) -> str:
    """By how much it is shifted, if that is all."""
    ours, theirs = _forms(got), _forms(expected)
    starts = [np.argwhere(one).min(axis=0) for one in (ours, theirs) if one.any()]
    if len(starts) == 2:
        down, right = (starts[1] - starts[0]).tolist()
        moved = np.roll(got, (down, right), (0, 1))
        if max(abs(down), abs(right)) <= FARTHEST and np.array_equal(moved, expected):
            return f"it is shifted: {right:+} in x and {down:+} in y bring it to its place"
    return ""
