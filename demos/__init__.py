"""Demos: small programs that show what graphics.h can do. `python -m demos` opens the gallery.

A demo is a module whose docstring begins with three paragraphs, which the gallery shows: a summary
of one line, the command that runs it, and what it shows. It has

    MODE     driver and mode, as initgraph() takes them
    draw()   draws its representative picture on the current page; also in VGAHI, for the menu
    main()   opens the screen with initgraph(*MODE) and runs until a key ends it

`main` leaves the screen open, so that the gallery goes on in the same window; `python -m demos`
calls closegraph() for all of them, whatever happens.
"""

from importlib import import_module
from types import ModuleType

NAMES = (
    "hello",
    "tour",
    "fills",
    "fonts",
    "palette",
    "sprites",
    "bounce",
    "bgidemo",
    "surfaces",
    "paper",
    "waterfall",
    "parametric",
    "turn",
    "explore",
    "paint",
    "piano",
    "keys",
    "clock",
    "two_windows",
)
"""The demos, in the order in which to learn from them."""


def load(name: str) -> ModuleType:
    """The module of a demo."""
    return import_module(f"demos.{name}")


def summary(demo: ModuleType) -> str:
    """What a demo is, in one line."""
    return _paragraph(demo, 0)


def lesson(demo: ModuleType) -> str:
    """What a demo shows, in a few sentences."""
    return _paragraph(demo, 2).replace("`", "")


def _paragraph(demo: ModuleType, number: int) -> str:
    paragraphs = (demo.__doc__ or "").split("\n\n")
    return " ".join(paragraphs[number].split())
