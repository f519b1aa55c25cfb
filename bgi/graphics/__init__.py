"""Class Graphics: every operation of the BGI, a few lines each, by topic.

A method adds the viewport's origin, chooses between the number path and the array path, and leaves
geometry to `bgi.raster` and pixels to `bgi.memory.page`. The functions of `bgi.api.X` are methods
in `bgi.graphics.X`; what each call means is described there.
"""

from bgi.graphics.curves import Curves
from bgi.graphics.drawing import Drawing
from bgi.graphics.filling import Filling
from bgi.graphics.images import Images
from bgi.graphics.text import Text


class Graphics(Drawing, Filling, Curves, Text, Images):
    """A graphics screen: its methods are graphics.h's functions."""
