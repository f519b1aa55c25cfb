"""How a surface is to be looked at: what the options of the command say and the keys change."""

from dataclasses import dataclass, replace
from math import log10, radians

from surfaces.arrays import Doubles
from surfaces.formulas import formula
from surfaces.plot import surface
from surfaces.scene import Plot
from surfaces.shape.sampling import Interval
from surfaces.space.mapping import Mapping, Projection
from surfaces.space.perspective import Perspective
from surfaces.space.projections import projection
from surfaces.space.transforms import Point, compose, rotation, scaling
from surfaces.systems.pen import System

LARGER = 1.15
"""How much larger the picture is for each step of `zoom`."""
DOUBLED = 3
"""How many steps of `wider` make the domain twice as wide."""


@dataclass
class Options:
    """Everything about a picture but its formula. Angles are in degrees."""

    x: Interval = (-3.0, 3.0)
    y: Interval = (-3.0, 3.0)
    z: Interval | None = None
    """Where `cut` cuts heights off; None: where x ends."""
    cut: bool = False
    """Whether it does; true to begin with, where z is given."""
    wider: float = 0
    """Steps by which the domain is wider than x and y say."""
    log: str = ""
    """The axes that are logarithmic, such as "xz"."""
    n: int = 200
    turn: float = 0.0
    """Degrees about z..."""
    tilt: float = 0.0
    """... and then toward the viewer."""
    turns: bool = False
    """Whether there is room around it, so that it stays on the screen however it is turned."""
    zoom: float = 0
    """Steps by which the picture is larger."""
    view: str = "paper"
    theta: float = 45.0
    rho_z: float = 1.0
    """The angle and the compression of the paper's view."""
    mode: str = "fill"
    color: str = "z"
    ramp: str = "rainbow"
    dither: bool = False
    contours: int = 0
    floor: int = 0
    box: bool = False
    axes: bool = False
    colorbar: bool = False
    title: str = ""
    """What stands above the picture; "": the formula."""

    def __post_init__(self) -> None:
        self.cut = self.cut or self.z is not None

    @property
    def domain(self) -> tuple[Interval, Interval]:
        """From where to where x and y run, `wider` reckoned in."""
        return self._widened("x", self.x), self._widened("y", self.y)

    def _widened(self, name: str, interval: Interval) -> Interval:
        if not self.wider:
            return interval
        if name in self.log:
            low, high = map(log10, interval)
            more = (high - low) / 2 * (2 ** (self.wider / DOUBLED) - 1)
            return float(f"{10 ** (low - more):.2g}"), float(f"{10 ** (high + more):.2g}")
        middle, half = sum(interval) / 2, (interval[1] - interval[0]) / 2
        half = float(f"{half * 2 ** (self.wider / DOUBLED):.2g}")  # a round number is read easily
        return middle - half, middle + half

    @property
    def heights(self) -> Interval | None:
        """From where to where z runs; None: as far as it likes."""
        if not self.cut or ("z" in self.log and not self.z):
            return None
        return self.z or self.domain[0]

    @property
    def projection(self) -> Projection:
        """The view, with the angle and the compression if it is the paper's."""
        if self.view == "paper":
            return Mapping(radians(self.theta), self.rho_z)
        view = projection(self.view)
        if isinstance(view, Perspective):  # enlarged, it must not come nearer to the eye
            return replace(view, distance=view.distance * max(1.0, self.size))
        return view

    @property
    def size(self) -> float:
        """How many times as large the picture is."""
        return float(LARGER**self.zoom)

    @property
    def transform(self) -> Doubles | None:
        """The turn, the tilt and the zoom in one; None if it never turns."""
        if not (self.turns or self.turn or self.tilt or self.zoom):
            return None
        return compose(
            rotation("z", radians(self.turn)),
            rotation(level(self.projection), radians(self.tilt)),
            scaling(self.size, self.size, self.size),
        )

    def draw(self, text: str, on: System | None = None) -> Plot:
        """Draw the surface of a formula; ValueError if it is none, or has no values there."""
        x, y = self.domain
        return surface(
            formula(text),
            x,
            y,
            self.n,
            z=self.heights,
            log=self.log,
            mode=self.mode,
            transform=self.transform,
            projection=self.projection,
            color=self.color,
            ramp=self.ramp,
            contours=self.contours,
            floor=self.floor,
            box=self.box,
            axes=self.axes,
            colorbar=self.colorbar,
            title=self.title or f"z = {text}",
            on=on,
        )


def level(view: Projection) -> Point:
    """The direction on the floor that is level on the screen, and leads to the right."""
    (x_right, x_down), (y_right, y_down), _ = view.arrows
    to_right = 1 if x_right * y_down > y_right * x_down else -1
    return to_right * y_down, -to_right * x_down, 0.0
