"""From a frame of the card to a picture on the screen: its colours, its size and its shape.

Every mode of the PC filled a monitor of 4:3, whatever its number of pixels; so their shape differs
from mode to mode. A picture is enlarged by a whole number of screen pixels across, and down by what
4:3 then asks for.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

from bgi.memory.card import Frame
from bgi.memory.sdl import pygame
from bgi.monitor.letters import drawn

# numpy, and what needs it, is imported late: most windows open without it, in half of the time.
if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Pixels = npt.NDArray[Any]
    Colors = npt.NDArray[np.uint8]


class Shape(NamedTuple):
    """What a mode looks like: its size, and whether its pixels are square."""

    width: int
    height: int
    square: bool = False

    @property
    def ratio(self) -> tuple[int, int]:
        """Width to height of the picture."""
        return (self.width, self.height) if self.square else (4, 3)

    def rows(self, across: int) -> int:
        """How high a picture is that is so wide."""
        wide, high = self.ratio
        return across * high // wide


def fit(shape: Shape, max_width: int, max_height: int) -> tuple[int, int]:
    """The size of the window for a mode.

    Each pixel is a whole number of screen pixels wide, as many as fit into the maximum, and at
    least one screen pixel high; if need be the window is larger than the maximum.
    """
    wide, high = shape.ratio
    least = math.ceil(shape.height * wide / (shape.width * high))
    return _enlarged(shape, max(_steps(shape, max_width, max_height), least))


def inside(shape: Shape, width: int, height: int) -> tuple[int, int]:
    """The size of the picture in a window: in whole steps; shrunk where even one is too large."""
    steps = _steps(shape, width, height)
    if steps:
        return _enlarged(shape, steps)
    part = min(1, width / shape.width, height / shape.rows(shape.width))
    return max(int(shape.width * part), 1), max(int(shape.rows(shape.width) * part), 1)


def _steps(shape: Shape, width: int, height: int) -> int:
    return min(width // shape.width, height // max(shape.rows(shape.width), 1))


def _enlarged(shape: Shape, steps: int) -> tuple[int, int]:
    return steps * shape.width, shape.rows(steps * shape.width)


def largest(desktop_width: int, desktop_height: int) -> tuple[int, int]:
    """The maximum for `fit`: 640 x 480 or twice that, if a tenth of the desktop stays free.

    Three times and more on a desktop of very small pixels.
    """
    step = min(desktop_width * 9 // 10 // 640, desktop_height * 9 // 10 // 480)
    step = min(max(step, 1), max(desktop_height // 720, 2))
    return step * 640, step * 480


def pixels(frame: Frame) -> Pixels:
    """The numbers of a frame's pixels, shape (height, width): indices, or also colours."""
    if frame.text is not None:
        return drawn(frame, frame.text)
    import numpy as np

    kind = np.dtype(np.uint8) if frame.pixel_bytes == 1 else np.dtype("<u4")
    return np.frombuffer(frame.pixels, kind).reshape(frame.height, frame.width)


def colors(palette: bytes) -> Colors:
    """A card's colours as an array (256, 3)."""
    import numpy as np

    return np.frombuffer(palette, np.uint8).reshape(256, 3)


def colored(frame: Frame, palette: bytes) -> bytes:
    """The colours of a window's pixels, of four bytes each."""
    from bgi.memory.matching import true_colors

    return true_colors(pixels(frame), colors(palette)).tobytes()


def surface(frame: Frame, palette: bytes) -> pygame.Surface:
    """The picture of a frame, one pixel for each of the frame's."""
    size = frame.width, frame.height
    if frame.pixel_bytes == 4:
        return pygame.image.frombuffer(colored(frame, palette), size, "RGBX")
    indices = frame.pixels if frame.text is None else pixels(frame).tobytes()
    picture = pygame.image.frombuffer(indices, size, "P")
    picture.set_palette(list(zip(palette[::3], palette[1::3], palette[2::3], strict=True)))
    return picture


def shot(frame: Frame, palette: bytes) -> bytes:
    """A PNG file of a frame: its indices and palette, or its colours."""
    from bgi.memory import imagefile

    return imagefile.png(pixels(frame), colors(palette))
