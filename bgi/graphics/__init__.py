"""Class Graphics: every operation of the BGI, a few lines each, by topic.

A method adds the viewport's origin, chooses between the number path and the array path, and leaves
geometry to `raster` and pixels to `Page`. What each call means is told in `bgi.api`.
"""

from bgi.graphics.curves import Curves
from bgi.graphics.images import Images
from bgi.graphics.text import Text


class Graphics(Curves, Text, Images):
    """A graphics screen: its methods are graphics.h's functions."""
