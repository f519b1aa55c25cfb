"""The part of the screen above the panel: the surface, kept as an image, and the cross-hair."""

from os import PathLike

import numpy as np

from bgi import (
    BLACK,
    COPY_PUT,
    NORM_WIDTH,
    SOLID_LINE,
    THICK_WIDTH,
    WHITE,
    YELLOW,
    Image,
    cleardevice,
    getimage,
    getmaxx,
    getmaxy,
    line,
    putimage,
    setcolor,
    setlinestyle,
    setviewport,
    writeimagefile,
)
from surfaces.explorer.options import Options
from surfaces.explorer.panel import PANEL
from surfaces.scene import Plot
from surfaces.space.transforms import Point

NEAR, FAR = 3, 10
"""From where to where the arms of the cross-hair reach, in pixels."""
ARMS = ((1, 0), (-1, 0), (0, 1), (0, -1))


class Canvas:
    """Where the surface is seen. It is drawn anew only when something has changed."""

    def __init__(self) -> None:
        self.width, self.height = getmaxx() + 1, getmaxy() + 1 - PANEL
        self.cross = self.width // 2, self.height // 2
        self.image: Image | None = None
        """The surface as it was drawn; None if that has to be done."""
        self.plot: Plot | None = None
        self.problem = ""
        """Why there is no surface to see."""

    def show(self, text: str, options: Options) -> None:
        """Put the surface of a formula on the page."""
        if self.image is None:
            self.image = self._drawn(text, options)
        cleardevice()
        putimage(0, 0, self.image, COPY_PUT)

    @np.errstate(all="ignore")  # formulas may be as wild as they like
    def _drawn(self, text: str, options: Options) -> Image:
        cleardevice()
        self._clip()
        setcolor(YELLOW)
        self.plot, self.problem = None, ""
        try:
            self.plot = options.draw(text)
        except ValueError as error:
            self.problem = str(error).splitlines()[0]
        self._unclip()
        return getimage(0, 0, self.width - 1, self.height - 1)

    def changed(self) -> None:
        """The surface has to be drawn anew."""
        self.image = None

    def save(self, file: str | PathLike[str]) -> None:
        """Write the surface that is on the page to a file."""
        writeimagefile(file, 0, 0, self.width - 1, self.height - 1)

    def point(self) -> Point | None:
        """The point of the surface under the cross-hair, or None beside it."""
        return None if self.plot is None else self.plot.pick(*self.cross)

    def move_cross(self, x: int, y: int) -> None:
        """Put the cross-hair at x, y, or as near as the canvas reaches."""
        self.cross = min(max(x, 0), self.width - 1), min(max(y, 0), self.height - 1)

    def show_cross(self) -> None:
        """The cross-hair: white on black, to be seen on any colour."""
        x, y = self.cross
        self._clip()
        for color, width in ((BLACK, THICK_WIDTH), (WHITE, NORM_WIDTH)):
            setlinestyle(SOLID_LINE, 0, width)
            for dx, dy in ARMS:
                line(x + NEAR * dx, y + NEAR * dy, x + FAR * dx, y + FAR * dy, color)
        self._unclip()

    def _clip(self) -> None:
        setviewport(0, 0, self.width - 1, self.height - 1, 1)

    def _unclip(self) -> None:
        setviewport(0, 0, getmaxx(), getmaxy(), 1)
