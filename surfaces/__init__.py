"""Surfaces z = f(x, y) in three dimensions, drawn with the two-dimensional calls of graphics.h.

After "A Very Simple Approach for 3-D to 2-D Mapping" by Dey, Abraham and Sanyal:

    from bgi import *
    from numpy import sin
    import surfaces

    initgraph(IBM8514, IBM8514LO)
    surfaces.surface(lambda x, y: sin(x * x + y * y), x=(-2.5, 2.5), y=(-2.5, 2.5))
    getch()
    closegraph()

The folders follow a point on its way: `space` (moving it, and mapping it to the screen), `shape` (a
surface as an array of points), `visible` (what is seen of it), `systems` (what it is drawn on).
`plot` puts them together.
"""

import surfaces.beside  # noqa: F401  (first)
from surfaces.animation import PillowMissing, save_gif
from surfaces.bodies import parametric, sheet
from surfaces.explorer import Explorer, explore
from surfaces.formulas import FormulaError, formula
from surfaces.modes import MODES
from surfaces.plot import surface
from surfaces.scene import Plot
from surfaces.shape.fields import FIELDS
from surfaces.shape.figures import FIGURES, Figure
from surfaces.shape.grid import Grid, data, sample
from surfaces.space.mapping import Axonometry, Mapping, Projection
from surfaces.space.perspective import Perspective
from surfaces.space.projections import PROJECTIONS, orthographic, perspective
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

# fmt: off
__all__ = [
    # Drawing a surface, and what was drawn
    "surface", "parametric", "sheet", "Plot",
    # What to draw: functions, data, formulas, the paper's figures
    "sample", "data", "Grid", "formula", "FormulaError", "FIGURES", "Figure",
    # How: the names that `mode`, `color`, `ramp` and `projection` take
    "MODES", "FIELDS", "RAMPS", "PROJECTIONS", "Ramp",
    # From space to the screen
    "Projection", "Mapping", "Axonometry", "orthographic", "Perspective", "perspective",
    # Moving and turning in space
    "translation", "scaling", "rotation", "affine", "compose", "power", "powers", "apply",
    # What to draw on, besides the screen of the BGI
    "Svg", "Text", "System", "Pen",
    # A window to walk round a surface in
    "explore", "Explorer",
    # Films
    "save_gif", "PillowMissing",
]
