"""Class State: what a graphics screen is, and all it remembers from one call to the next.

Its mode and pages of video memory, palette, viewport, current position and settings. The public
methods are calls of graphics.h; `bgi.api.screen` says what each means.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from bgi.constants import SOLID_LINE, THICK_WIDTH, grError
from bgi.fonts.chr import StrokedFont
from bgi.kernel.arguments import Number, Numbers, broadcast, whole
from bgi.kernel.modes import YASP, GraphicsMode
from bgi.kernel.state import KERNEL
from bgi.memory import rgb
from bgi.memory.card import Card
from bgi.memory.page import Page
from bgi.memory.palette import Palette
from bgi.monitor import Monitor
from bgi.monitor.headless import Headless
from bgi.raster.patterns import LINE_PATTERNS, line_mask
from bgi.settings import Settings, palettetype, viewporttype


class State:
    """One graphics screen: tests and programs may hold several at once.

    Every attribute is there once a mode has been entered.
    """

    def __init__(
        self, mode: GraphicsMode, card: Card | None = None, monitor: Monitor | None = None
    ) -> None:
        """Enter `mode` on a card that a monitor shows: by default a new card, and no window."""
        self.card = card or Card()
        self.monitor = monitor or Headless()
        self.path = ""
        """Where fonts are looked for: what initgraph() was given."""
        self.enter(mode)

    def enter(self, mode: GraphicsMode) -> None:
        """Set a mode: clears the pages, everything back to its default."""
        self.mode = mode
        self._mask = mode.maxcolor if mode.pixel_bytes == 1 else rgb.MASK
        size = mode.width, mode.height
        self.card.set_mode(*size, mode.pages, mode.pixel_bytes, mode.square)
        self.pages = [Page(self.card.page(n), *size, mode.pixel_bytes) for n in range(mode.pages)]
        self.palette = Palette(mode, self.card.palette)
        self.aspect = mode.xasp, YASP
        self._active = 0
        self.page = self.pages[0]
        self.graphdefaults()

    def graphdefaults(self) -> None:
        """Settings, palette, viewport and current position as after initgraph."""
        self.settings = Settings.defaults(self.mode.maxcolor, self.mode.width, self.mode.height)
        self._font: StrokedFont | None = None
        self.palette.reset()
        self._use_viewport()
        self._use_line_settings()

    def _use_viewport(self) -> None:
        """Take over the viewport: its origin for all drawing, its box for the active page."""
        view = self.settings.view
        self._dx, self._dy = self._origin = view.left, view.top
        if view.clip:
            self.page.clip_to((view.left, view.top, view.right, view.bottom))
        else:
            self.page.clip_to((0, 0, self.mode.width - 1, self.mode.height - 1))

    def _use_line_settings(self) -> None:
        """Take over line style, width and write mode, as the booleans that drawing asks for."""
        line = self.settings.line
        self._pattern = line_mask(line.upattern)
        self._thick = line.thickness == THICK_WIDTH
        self._xor = bool(self.settings.writemode)
        self._solid = line.upattern == LINE_PATTERNS[SOLID_LINE] and not self._xor
        self._plain = self._solid and not self._thick

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
        left, top = whole("left", left), whole("top", top)
        right, bottom = whole("right", right), whole("bottom", bottom)
        clip = whole("clip", clip)
        if not (0 <= left <= right < self.mode.width and 0 <= top <= bottom < self.mode.height):
            KERNEL.result.set(grError)
            return
        self.settings.view = viewporttype(left, top, right, bottom, clip)
        self.settings.x = self.settings.y = 0
        self._use_viewport()

    def getviewsettings(self) -> viewporttype:
        """The viewport: absolute corners, and whether clipping is on."""
        return replace(self.settings.view)

    def clearviewport(self) -> None:
        """Clear the viewport to index 0, whatever clip is; current position to 0, 0."""
        view = self.settings.view
        self.page.fill((view.left, view.top, view.right, view.bottom), 0)
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
        """Set the drawing colour, masked to the mode's depth."""
        self.settings.color = whole("color", color) & self._mask

    def getcolor(self) -> int:
        """The drawing colour."""
        return self.settings.color

    def setbkcolor(self, color: Number) -> None:
        """Give index 0 the colour of entry `color`, at once, everywhere."""
        self.palette.set_background(whole("color", color) & max(15, self._mask))

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
        """Set the first entries of the palette, -1 leaving one; -11 and nothing if any is bad."""
        given = palette.colors[: palette.size] if isinstance(palette, palettetype) else palette
        colors = [whole(f"palette[{i}]", color) for i, color in enumerate(given)]
        if not self.palette.set_all({i: c for i, c in enumerate(colors) if c != -1}):
            KERNEL.result.set(grError)

    def getpalette(self) -> palettetype:
        """The hardware colours of the palette."""
        return palettetype(self.palette.size, self.palette.values[: self.palette.size])

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
