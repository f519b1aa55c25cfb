"""What a key or the mouse turns: one of the `Options`, a step further."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf

from surfaces.explorer.options import Options
from surfaces.modes import MODES
from surfaces.shape.fields import FIELDS
from surfaces.space.projections import PROJECTIONS
from surfaces.systems.colors import RAMPS


@dataclass(frozen=True)
class Dial:
    """A number with a step and two ends."""

    name: str
    step: float
    low: float = -inf
    high: float = inf

    def turn(self, options: Options, steps: float) -> None:
        """So many steps up or down, as far as it goes."""
        value = getattr(options, self.name) + steps * self.step
        setattr(options, self.name, min(max(value, self.low), self.high))


@dataclass(frozen=True)
class Switch:
    """One of several values, and after the last the first again."""

    name: str
    values: Sequence[object]

    def turn(self, options: Options, steps: float) -> None:
        """The next one; from a value that is none of them, the first."""
        now = getattr(options, self.name)
        place = self.values.index(now) + 1 if now in self.values else 0
        setattr(options, self.name, self.values[place % len(self.values)])


TURN, TILT = Dial("turn", 5), Dial("tilt", 5)
ZOOM, WIDER = Dial("zoom", 1, -10, 20), Dial("wider", 1, -12, 12)
THETA, RHO_Z = Dial("theta", 5, 5, 85), Dial("rho_z", 0.1, 0.1, 1)
CELLS = Dial("n", 50, 10, 400)
VIEW = Switch("view", tuple(PROJECTIONS))
MODE = Switch("mode", tuple(MODES))
RAMP = Switch("ramp", tuple(RAMPS))
COLOR = Switch("color", tuple(FIELDS))
CONTOURS, FLOOR = Switch("contours", (0, 5, 10, 20)), Switch("floor", (0, 5, 10, 20))
CUT, BOX, AXES, COLORBAR = (
    Switch(name, (False, True)) for name in ("cut", "box", "axes", "colorbar")
)
