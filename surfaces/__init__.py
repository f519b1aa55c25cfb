"""Surfaces z = f(x, y) in three dimensions, drawn with the two-dimensional calls of graphics.h.

After "A Very Simple Approach for 3-D to 2-D Mapping" by Dey, Abraham and Sanyal::

    from bgi import *
    from numpy import sin
    import surfaces

    initgraph(IBM8514, IBM8514LO)
    surfaces.surface(lambda x, y: sin(x * x + y * y), x=(-2.5, 2.5), y=(-2.5, 2.5), n=60)
    getch()
    closegraph()
"""

from surfaces.functions import FIGURES, Figure
from surfaces.mapping import Mapping
from surfaces.plot import surface
from surfaces.transforms import (
    affine,
    apply,
    compose,
    power,
    powers,
    rotation,
    scaling,
    translation,
)

__all__ = [
    "FIGURES",
    "Figure",
    "Mapping",
    "affine",
    "apply",
    "compose",
    "power",
    "powers",
    "rotation",
    "scaling",
    "surface",
    "translation",
]
