"""Class State: what a graphics screen is, and all it remembers from one call to the next.

Its mode and pages of video memory, palette, viewport, current position and settings. The public
methods are calls of graphics.h; `bgi.api.screen` says what each means.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from bgi.constants import USER_FILL, USERBIT_LINE, grError
from bgi.fonts.bitmap import CELL
from bgi.fonts.chr import StrokedFont
from bgi.graphics.linestyle import line_style
from bgi.kernel.arguments import Number, Numbers, broadcast, length, whole
from bgi.kernel.modes import YASP, GraphicsMode
from bgi.kernel.state import KERNEL
from bgi.memory import rgb
from bgi.memory.card import Card
from bgi.memory.packedpage import PackedPage
from bgi.memory.page import Page
from bgi.memory.palette import Palette
from bgi.monitor import Monitor
from bgi.monitor.headless import Headless
from bgi.raster.patterns import FILL_PATTERNS, LINE_PATTERNS, SOLID_ROWS, shifted_half
from bgi.settings import Settings, palettetype, viewporttype

MAX_ENTRIES = 256
"""No palette has more; C's struct has its size before them."""

_ENLARGEMENT_BITS = 31
"""The bits of a character size that count for the built-in font."""


class State:
    """One graphics screen in one mode: tests and programs may hold several at once.

    Another mode is another object, on the same card: so a thread that is drawing when the mode
    changes ends its call on pages that are as it knows them.
    """

    def __init__(
        self, mode: GraphicsMode, card: Card | None = None, monitor: Monitor | None = None
    ) -> None:
        """Enter `mode` on a card that a monitor shows: by default a new card, and no window.

        Clears the pages; everything is at its default.
        """
        self.card = card or Card()
        self.monitor = monitor or Headless()
        self.path = ""
        """Where fonts are looked for: what initgraph() was given."""
        self.mode = mode
        indexed = mode.pixel_bytes == 1
        self._mask = mode.maxcolor if indexed else rgb.MASK
        self._given_mask = 0xFF if indexed else rgb.MASK
        size = mode.width, mode.height
        self.card.set_mode(*size, mode.pages, mode.pixel_bytes, mode.square)
        self._packed, self._tall_text = mode.file.packed, mode.file.tall_text
        kind = PackedPage if self._packed else Page
        self.pages = [kind(self.card.page(n), *size, mode.pixel_bytes) for n in range(mode.pages)]
        # An array: numpy 1 gives a number alone the type that its value fits into.
        self._bits = np.array([self._mask], self.pages[0].flat.dtype)
        self.palette = Palette(mode, self.card.palette)
        self.aspect = mode.xasp, YASP
        self._active = 0
        self.page = self.pages[0]
        self.graphdefaults()

    def graphdefaults(self) -> None:
        """Settings, palette, viewport and current position as after initgraph."""
        self.settings = Settings.defaults(self.mode.maxcolor, self.mode.width, self.mode.height)
        self._font: StrokedFont | None = None
        self._use_charsize(1)
        self.palette.reset()
        self._use_viewport()
        self._use_line_settings()
        self._use_color(self.settings.color)
        self._use_fill_settings()

    def _use_viewport(self) -> None:
        """Take over the viewport: its origin for all drawing, its box for the active page."""
        view, page = self.settings.view, self.page
        left, top = self._dx, self._dy = self._origin = view.left, view.top
        if view.clip:
            box = left, top, view.right, view.bottom
        else:
            box = 0, 0, page.width - 1, page.height - 1
        if box != page.box:
            page.clip_to(box)

    def _use_line_settings(self) -> None:
        """Take over line style, width and write mode."""
        settings, line = self.settings, self.settings.line
        style = line.linestyle
        pattern = line.upattern if style == USERBIT_LINE else LINE_PATTERNS[style]
        self._dashes, self._xor, self._thick, self._wide, self._plain, self._bold = line_style(
            pattern, line.thickness, settings.writemode, self._packed
        )

    def _use_charsize(self, size: int) -> None:
        """Take over a size for the built-in font: width and height of its characters."""
        size = size & _ENLARGEMENT_BITS or 1
        self._cell = CELL * size, CELL * (size + (self._tall_text and size > 1))

    def _use_color(self, color: int) -> None:
        """Take over the drawing colour, as the indices that it is drawn in."""
        self.settings.color = color
        self._ink = self._curve_ink = self._index(color) if self._packed else color & self._mask
        if self._packed and self.mode.colors == 2:  # where curves are drawn pixel by pixel
            self._curve_ink = color & self._mask

    def _use_fill_settings(self) -> None:
        """Take over pattern and fill colour, as the rows and the index that areas are filled in."""
        fill = self.settings.fill
        rows = self.settings.user_rows if fill.pattern == USER_FILL else FILL_PATTERNS[fill.pattern]
        self._fill_rows, self._fill_ink = rows, fill.color & self._mask
        if self._packed:
            self._fill_rows = shifted_half(rows) if self.mode.colors == 4 else rows
            self._fill_ink = self._fill_index(fill.color)

    def _index(self, color: Any) -> Any:
        """The index that a colour, or an array of them, is drawn in."""
        return clamped(color, self.mode.maxcolor) if self._packed else color & self._mask

    def _fill_index(self, color: Any) -> Any:
        """The index that areas are filled in: two packed colours have no pattern in colour 0."""
        index = self._index(color)
        two = self._packed and self.mode.colors == 2
        return index | 1 if two and self._fill_rows != SOLID_ROWS else index

    def describe(self) -> list[str]:
        """What there is to know about it, for the board that the window shows."""
        view, here = self.settings.view, self.settings
        corners = f"{view.left} {view.top} {view.right} {view.bottom}"
        return [
            f"viewport {corners}{', clipping' if view.clip else ''}",
            f"active page {self._active}, at {here.x}, {here.y}",
            f"color {here.color}, fill {here.fill.pattern} in {here.fill.color}",
        ]

    # The screen

    def getmaxx(self) -> int:
        """The largest x of the screen."""
        return self.mode.width - 1

    def getmaxy(self) -> int:
        """The largest y of the screen."""
        return self.mode.height - 1

    def getmaxcolor(self) -> int:
        """The largest colour index."""
        return self.mode.maxcolor

    def cleardevice(self) -> None:
        """Clear the active page to index 0; current position to 0, 0."""
        self.page.clear()
        self.settings.x = self.settings.y = 0

    # Viewport and current position

    def setviewport(
        self, left: Number, top: Number, right: Number, bottom: Number, clip: Number
    ) -> None:
        """Set the viewport (absolute corners); -11 unless it lies within the screen."""
        left = left if type(left) is int else whole("left", left)
        top = top if type(top) is int else whole("top", top)
        right = right if type(right) is int else whole("right", right)
        bottom = bottom if type(bottom) is int else whole("bottom", bottom)
        clip = clip if type(clip) is int else whole("clip", clip)
        mode, here = self.mode, self.settings
        if not (0 <= left <= right < mode.width and 0 <= top <= bottom < mode.height):
            KERNEL.result.set(grError)
            return
        view = here.view
        view.left, view.top, view.right, view.bottom, view.clip = left, top, right, bottom, clip
        here.x = here.y = 0
        self._use_viewport()

    def getviewsettings(self) -> viewporttype:
        """The viewport: absolute corners, and whether clipping is on."""
        view = self.settings.view
        return viewporttype(view.left, view.top, view.right, view.bottom, view.clip)

    def clearviewport(self) -> None:
        """Clear the viewport to index 0, whatever clip is; current position to 0, 0."""
        view = self.settings.view
        self.page.fill(view.left, view.top, view.right, view.bottom, 0)
        self.settings.x = self.settings.y = 0

    def moveto(self, x: Number, y: Number) -> None:
        """Set the current position."""
        self.settings.x, self.settings.y = whole("x", x), whole("y", y)

    def moverel(self, dx: Number, dy: Number) -> None:
        """Shift the current position."""
        x, y = whole("dx", dx), whole("dy", dy)
        self.settings.x += x
        self.settings.y += y

    def getx(self) -> int:
        """The current position's x."""
        return self.settings.x

    def gety(self) -> int:
        """The current position's y."""
        return self.settings.y

    # Pages

    def setactivepage(self, page: Number) -> None:
        """Draw on that page from now on; an unknown page is ignored."""
        number = whole("page", page)
        if 0 <= number < len(self.pages):
            self._active = number
            self.page = self.pages[number]
            self._use_viewport()

    def setvisualpage(self, page: Number) -> None:
        """Show that page; an unknown page is ignored."""
        number = whole("page", page)
        if 0 <= number < len(self.pages):
            self.card.visible = number
            self.monitor.flip()

    def getactivepage(self) -> int:
        """The page drawn on."""
        return self._active

    def getvisualpage(self) -> int:
        """The page shown."""
        return self.card.visible

    def swapbuffers(self) -> None:
        """Show the active page and draw on the other; returns when it has been shown."""
        self.card.visible = self._active
        self.setactivepage(1 if self._active == 0 else 0)
        self.monitor.show()

    # Colours and palette

    def setcolor(self, color: Number) -> None:
        """Set the drawing colour; of an index the low byte is kept."""
        number = color if type(color) is int else whole("color", color)
        self._use_color(number & self._given_mask)

    def getcolor(self) -> int:
        """The drawing colour as given."""
        return self.settings.color

    def setbkcolor(self, color: Number) -> None:
        """Give index 0 the colour of entry `color`, at once, everywhere; ignored if unknown."""
        number = whole("color", color)
        if 0 <= number <= max(15, self._mask):
            self.palette.set_background(number)

    def getbkcolor(self) -> int:
        """The number last given to setbkcolor."""
        return self.palette.background

    def getpalettesize(self) -> int:
        """How many entries of the palette can be changed."""
        return self.palette.size

    def getdefaultpalette(self) -> palettetype:
        """The palette that the mode begins with."""
        colors = self.palette.default
        return palettetype(len(colors), colors)

    def setpalette(self, index: Number, color: Number) -> None:
        """Give a palette entry a hardware colour; -11 where the adapter cannot."""
        if not self.palette.set(whole("index", index), whole("color", color)):
            KERNEL.result.set(grError)

    def setallpalette(self, palette: palettetype | Sequence[Number]) -> None:
        """Set the first entries of the palette, -1 leaving one; -11 where the adapter cannot."""
        given = palette.colors if isinstance(palette, palettetype) else palette
        if length("palette", given) > MAX_ENTRIES + 1:
            raise ValueError(f"palette may hold {MAX_ENTRIES} colours at most")
        colors = [
            color if type(color) is int else whole(f"palette[{i}]", color)
            for i, color in enumerate(given)
        ]
        if isinstance(palette, palettetype):
            del colors[max(whole("palette.size", palette.size), 0) :]
        size = self.mode.colors
        if colors[:1] == [size] and len(colors) == size + 1:  # the struct as C lays it out
            del colors[0]
        if not self.palette.set_all(colors):
            KERNEL.result.set(grError)

    def getpalette(self) -> palettetype:
        """The values of the palette, of which CGA shows only the first."""
        return palettetype(len(self.palette.values), list(self.palette.values))

    def setrgbpalette(self, index: Numbers, red: Numbers, green: Numbers, blue: Numbers) -> None:
        """Load registers of the VGA's DAC, or entries of the 8514's palette; else -11."""
        numbers = broadcast(index=index, red=red, green=green, blue=blue)
        registers, *components = (array.tolist() for array in numbers)
        colors = list(zip(*components, strict=True))
        if not self.palette.set_rgb(registers, colors):
            KERNEL.result.set(grError)

    # The mode

    def getgraphmode(self) -> int:
        """The number of the mode."""
        return self.mode.number

    def getmaxmode(self) -> int:
        """The largest mode number of the driver."""
        return KERNEL.drivers.mode_range(self.mode.driver)[1]

    def getmodename(self, mode: Number) -> str | None:
        """The driver's name for one of its modes, None for an unknown one."""
        found = KERNEL.drivers.find(self.mode.driver, whole("mode", mode))
        return None if found is None else found.name

    def getdrivername(self) -> str:
        """The name of the driver's file."""
        return KERNEL.drivers.name(self.mode.driver) or ""


def clamped(color: Any, largest: int) -> Any:
    """The low byte of a colour, or of an array of them, but at most the largest colour."""
    low = color & 0xFF
    return low - (low > largest) * (low - largest)
