"""What the explorer says in words: where the cross-hair is, and how the options stand."""

from surfaces.explorer.options import LARGER, Options
from surfaces.shape.sampling import Interval
from surfaces.space.transforms import Point


def read_out(point: Point | None) -> str:
    """The point under the cross-hair."""
    if point is None:
        return "beside the surface"
    return "   ".join(f"{name} {_number(at)}" for name, at in zip("xyz", point, strict=True))


def _number(value: float) -> str:
    """In nine characters; by a power of ten, where no decimals would tell it."""
    return f"{value:9.4f}" if 0.001 <= abs(value) < 10000 or not value else f"{value:9.2e}"


def status(options: Options) -> tuple[str, str]:
    """Two lines: where one looks at the surface from, and how it is drawn."""
    view = options.view
    if view == "paper":
        view = f"theta {options.theta:.0f} rho_z {options.rho_z:.1f}"
    first = (
        f"turn {options.turn % 360:.0f}",
        f"tilt {options.tilt:.0f}",
        f"zoom {LARGER**options.zoom:.2g}",
        view,
        _extent(options),
    )
    second = (
        f"{options.mode} {options.n}x{options.n}",
        f"{options.ramp}: {options.color}",
        f"contours {options.contours}" if options.contours else "",
        f"floor {options.floor}" if options.floor else "",
    )
    return "  ".join(first), "  ".join(filter(None, second))


def _extent(options: Options) -> str:
    """From where to where x, y and z run."""
    x, y = options.domain
    named = {"x": x, "y": y, "z": options.heights}
    if x == y:
        named = {"x, y": x, "z": options.heights}
    return "  ".join(f"{name} {_range(ends)}" for name, ends in named.items() if ends)


def _range(ends: Interval) -> str:
    return f"{ends[0]:.4g} to {ends[1]:.4g}"
