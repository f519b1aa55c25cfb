"""Surfaces z = f(x, y) in three dimensions, drawn with the two-dimensional calls of graphics.h.

After "A Very Simple Approach for 3-D to 2-D Mapping" by Dey, Abraham and Sanyal::

    from bgi import *
    from numpy import sin
    import surfaces

    initgraph(IBM8514, IBM8514LO)
    surfaces.surface(lambda x, y: sin(x * x + y * y), x=(-2.5, 2.5), y=(-2.5, 2.5))
    getch()
    closegraph()
"""

from surfaces.colours import RAMPS, Ramp
from surfaces.functions import FIGURES, Figure
from surfaces.grid import Grid, data, sample
from surfaces.mapping import Axonometry, Mapping, Projection
from surfaces.modes import MODES
from surfaces.pen import Pen, System
from surfaces.plot import Plot, parametric, surface
from surfaces.projections import PROJECTIONS, orthographic
from surfaces.svg import Svg
from surfaces.text import Text
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
    "MODES",
    "PROJECTIONS",
    "RAMPS",
    "Axonometry",
    "Figure",
    "Grid",
    "Mapping",
    "Pen",
    "Plot",
    "Projection",
    "Ramp",
    "Svg",
    "System",
    "Text",
    "affine",
    "apply",
    "compose",
    "data",
    "orthographic",
    "parametric",
    "power",
    "powers",
    "rotation",
    "sample",
    "scaling",
    "surface",
    "translation",
]
