"""From a palette index to the colour on the glass.

A pixel holds an index. The palette gives each index a hardware value, and the adapter turns that
value into red, green and blue:

* EGA and VGA: a value of 0..63, on the VGA the number of one of its DAC registers, which
  setrgbpalette() loads. At mode set the registers hold the EGA's 64 colours: bits `r g b R G B`
  from bit 5 down; the large letters add two thirds of full light, the small ones one third. The
  200-line modes have 16 colours only: bit 4 is the intensity, bits 2..0 are R, G and B.
* CGA: index 0 is any of 16 colours, the others are fixed by the mode. In its two-colour mode
  setbkcolor() gives the *foreground* its colour, because that is what the hardware does. Its driver
  keeps a palette of 16 values all the same, and takes any of them.
* 8514/A: 256 entries, each loaded straight with RGB.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bgi.constants import VGA
from bgi.kernel.modes import GraphicsMode
from bgi.memory import rgb
from bgi.memory.rgb import EGA_VALUES, RGB, SIXTEEN, ega_rgb

_EGA200 = [0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23]


def six_bits(component: int) -> int:
    """A DAC component 0..63 as eight bits: 0, 21, 42, 63 are 00, 55, AA, FF."""
    component &= 63
    return component << 2 | component >> 4


def _dac_200() -> list[RGB]:
    return [SIXTEEN[value & 7 | value >> 1 & 8] for value in range(64)]


def _vga_256() -> list[RGB]:
    """The PC's default 256 colours (VGA mode 13h): 16 colours, 16 greys, 216 hues, 8 blacks.

    The last black gives way to white: it is the colour that a screen begins to draw in.
    """
    greys = [0, 5, 8, 11, 14, 17, 20, 24, 28, 32, 36, 40, 45, 50, 56, 63]
    wheel = [(i, 0, 4) for i in range(5)] + [(4, 0, i) for i in (3, 2, 1, 0)]
    wheel += [(4, i, 0) for i in (1, 2, 3, 4)] + [(i, 4, 0) for i in (3, 2, 1, 0)]
    wheel += [(0, 4, i) for i in (1, 2, 3, 4)] + [(0, i, 4) for i in (3, 2, 1)]
    ramps = [
        [0, 16, 31, 47, 63],
        [31, 39, 47, 55, 63],
        [45, 49, 54, 58, 63],
        [0, 7, 14, 21, 28],
        [14, 17, 21, 24, 28],
        [20, 22, 24, 26, 28],
        [0, 4, 8, 12, 16],
        [8, 10, 12, 14, 16],
        [11, 12, 13, 15, 16],
    ]
    six = [(g, g, g) for g in greys]
    six += [(ramp[r], ramp[g], ramp[b]) for ramp in ramps for r, g, b in wheel]
    six += [(0, 0, 0)] * 7 + [(63, 63, 63)]
    return SIXTEEN + [(six_bits(r), six_bits(g), six_bits(b)) for r, g, b in six]


_OWN = 255
"""The register that holds an RGB background of a window."""

_DAC_350 = [ega_rgb(value) for value in range(64)]
_WHITE = SIXTEEN[15]

# name -> (hardware value of each index, colour of each hardware value)
DEFAULTS: dict[str, tuple[list[int], list[RGB]]] = {
    "EGA350": (EGA_VALUES, _DAC_350),
    "EGA200": (_EGA200, _dac_200()),
    "EGA64HI": ([0, 1, 4, 7], _DAC_350),
    "CGAC0": ([0, 10, 12, 14], SIXTEEN),
    "CGAC1": ([0, 11, 13, 15], SIXTEEN),
    "CGAC2": ([0, 2, 4, 6], SIXTEEN),
    "CGAC3": ([0, 3, 5, 7], SIXTEEN),
    "CGAHI": ([0, 15], SIXTEEN),
    "MONO": ([0, 1], [(0, 0, 0), _WHITE]),
    "WINDOW": (EGA_VALUES, _DAC_350),
    "IBM8514": (list(range(256)), _vga_256()),
}


_CHANGEABLE = {
    **dict.fromkeys(("EGA350", "EGA200", "WINDOW"), (16, 63)),
    **dict.fromkeys(("CGAC0", "CGAC1", "CGAC2", "CGAC3"), (1, 15)),
    "EGA64HI": (4, 63),
}
"""How many indices setpalette() can give another look, and which bits of a value tell it."""


class Palette:
    """The palette of one screen: index -> hardware value -> RGB, written through to the card."""

    def __init__(self, mode: GraphicsMode, shown: NDArray[np.uint8]) -> None:
        """Take the default palette of `mode`; `shown` is the card's (256, 3) table of colours."""
        self.kind = mode.palette
        self._fixed = self.kind == "IBM8514"
        self._has_dac = mode.driver == VGA or self._fixed
        self.shown = shown
        """The colour of each index, as the screen shows it now."""
        self.shown[:] = 0
        self._bytes = self.shown.reshape(-1).data
        self._changeable, self._bits = _CHANGEABLE.get(self.kind, (0, 0))
        self._dac: list[RGB] = []
        self._hardware: list[int] = []
        self.values: list[int] = []
        """What getpalette() says; the adapter shows what it can of them."""
        self.background = 0
        self._load_dac()
        self.reset()

    def _load_dac(self) -> None:
        colors = DEFAULTS[self.kind][1]
        self._dac = colors + [(0, 0, 0)] * (256 - len(colors))

    def reset(self) -> None:
        """Give every index its default value again (graphdefaults); DAC registers keep theirs."""
        self.values = self.default
        self._hardware = list(DEFAULTS[self.kind][0])
        self.background = 0
        if self.kind == "IBM8514":  # its palette *is* the DAC
            self._load_dac()
        self._show()

    def _show(self) -> None:
        self.shown[: len(self._hardware)] = [self._dac[value] for value in self._hardware]

    @property
    def _has_palette(self) -> bool:
        return self.is_ega or self.kind == "IBM8514"

    @property
    def is_ega(self) -> bool:
        """Whether setpalette() takes the EGA's hardware values 0..63."""
        return self.kind.startswith("EGA") or self.kind == "WINDOW"

    @property
    def size(self) -> int:
        """What getpalettesize() says: only entries that can be changed count."""
        return len(self.values) if self._has_palette else 1

    @property
    def default(self) -> list[int]:
        """The values that the mode begins with."""
        return list(DEFAULTS[self.kind][0]) if self._has_palette else list(range(16))

    def set(self, index: int, value: int) -> bool:
        """Give `index` a value, of which the low byte counts; False, and no change, on the 8514.

        An index that the palette lacks is ignored, and -1 leaves an index as it is.
        """
        if self._fixed:
            return False
        if 0 <= index < len(self.values) and value != -1:
            self.values[index] = value & 0xFF
            if index < self._changeable:
                self._hardware[index] = value & self._bits
                self._bytes[3 * index : 3 * index + 3] = bytes(self._dac[value & self._bits])
        return True

    def set_all(self, values: Sequence[int]) -> bool:
        """Give the first indices their values, each as `set` does."""
        for index, value in enumerate(values):
            self.set(index, value)
        return not self._fixed

    def set_background(self, color: int) -> None:
        """What setbkcolor() does: index 0 takes the colour of entry `color`; nothing is redrawn."""
        self.background = color
        if rgb.is_rgb(color):
            self._dac[_OWN] = rgb.split(color)
            self._hardware[0] = self.values[0] = _OWN
        elif self.is_ega:
            index = color % len(self.values)
            self.values[0] = self.values[index] if color else 0
            self._hardware[0] = self._hardware[index] if color else 0
        elif self.kind == "IBM8514":
            self._dac[0] = self._dac[color] if color else (0, 0, 0)
        elif self.kind == "CGAHI":  # the hardware colours the foreground; 0 leaves it
            self._hardware[1] = color or self._hardware[1]
        elif self.kind.startswith("CGAC"):
            self._hardware[0] = self.values[0] = color
        self._show()

    def set_rgb(self, registers: Sequence[int], colors: Sequence[RGB]) -> bool:
        """Load DAC registers, of whose numbers the low byte counts; False if there are none.

        VGA components are 0..63; the 8514's are 0..255, of which the upper six bits count.
        """
        if not self._has_dac:
            return False
        shift = 2 if self.kind == "IBM8514" else 0
        self.load(registers, [(r >> shift, g >> shift, b >> shift) for r, g, b in colors])
        return True

    def load(self, registers: Sequence[int], colors: Sequence[RGB]) -> None:
        """Load DAC registers with components of six bits, as the BIOS does; nothing without DAC."""
        if self._has_dac:
            for register, (red, green, blue) in zip(registers, colors, strict=True):
                self._dac[register & 0xFF] = six_bits(red), six_bits(green), six_bits(blue)
            self._show()

    def loaded(self, register: int) -> RGB:
        """The components of a DAC register, six bits each."""
        red, green, blue = self._dac[register & 0xFF]
        return red >> 2, green >> 2, blue >> 2
