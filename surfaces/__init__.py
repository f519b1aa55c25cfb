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

from surfaces.modes import MODES
from surfaces.plot import Plot, parametric, surface
from surfaces.shape.functions import FIGURES, Figure
from surfaces.shape.grid import Grid, data, sample
from surfaces.space.mapping import Axonometry, Mapping, Projection
from surfaces.space.projections import PROJECTIONS, orthographic
from surfaces.space.transforms import (
    affine,
    apply,
    compose,
    power,
    powers,
    rotation,
    scaling,
    translation,
)
from surfaces.systems.characters import Text
from surfaces.systems.colors import RAMPS, Ramp
from surfaces.systems.pen import Pen, System
from surfaces.systems.svg import Svg

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
