"""Class Slow: stands before a screen, and shows how each call sets its pixels, one after the other.

A call draws as fast as ever; what it has changed is then taken back and set again in the order of
the algorithm (`bgi.raster.order`), at the pace that was asked for. So the picture at the end is the
same. Nothing of this is there at full speed.
"""

from __future__ import annotations

import functools
import inspect
import sys
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from bgi.graphics import Graphics
from bgi.kernel import callers
from bgi.kernel.arguments import broadcast, is_array, polygon_points
from bgi.kernel.state import KERNEL
from bgi.raster import order
from bgi.raster.order import Ints, Points

LOOKS = 60
"""Looks at the screen in a second: each shows what has been set meanwhile."""

ESCAPE = b"\x1b"

Order = Callable[[Ints, Ints], Ints]


def parse_rate(text: str) -> int:
    """Pixels a second, as BGI_SLOW says; ValueError if that is no such number."""
    if not (text.isascii() and text.isdigit()):
        raise ValueError(f"BGI_SLOW is {text!r}; it is a number of pixels a second, such as 500")
    return int(text)


class Slow:
    """Everything that a screen is; calls that draw do so slowly."""

    def __init__(self, screen: Graphics) -> None:
        self._screen = screen

    def __getattr__(self, name: str) -> Any:
        method = getattr(self._screen, name)
        order_of = ORDERS.get(name)
        if order_of is None:
            return method

        def call(*given: Any) -> Any:
            arguments = _bound(name, given)
            for one in _calls(name, arguments, method):
                self._watch(one, functools.partial(method, **one), order_of)
            if KERNEL.pace.stepping:
                self._step()

        return call

    def putpixel(self, x: Any, y: Any, color: Any) -> None:
        """Set pixels, one after the other."""
        if KERNEL.pace.rate > 0 and not (is_array(x) or is_array(y) or is_array(color)):
            self._screen.putpixel(x, y, color)
            self._wait(1)
            if KERNEL.pace.stepping:
                self._step()
        else:
            self.__getattr__("putpixel")(x, y, color)

    def _watch(self, arguments: dict[str, Any], draw: Callable[[], Any], order_of: Any) -> None:
        """Draw, take it back, and set it pixel by pixel."""
        screen, rate = self._screen, KERNEL.pace.rate
        if rate <= 0 or screen.getactivepage() != screen.getvisualpage():
            draw()
            return
        page = screen.page
        wanted: Order = order_of(screen, arguments)
        before = page.flat.copy()
        draw()
        places = np.flatnonzero(before != page.flat)
        if len(places):
            y, x = np.divmod(places, page.width)
            at_once = max(rate // LOOKS, 1)
            for count in page.replay(before, places[wanted(x, y)], at_once):
                self._wait(count)

    def _wait(self, pixels: int) -> None:
        pace = KERNEL.pace
        pace.owed += pixels / pace.rate
        if pace.owed >= 1 / LOOKS:
            self._screen.monitor.sleep(pace.owed * 1000)
            pace.owed = 0.0

    def _step(self) -> None:
        """Say which line of the program has drawn, and wait for a key: Escape is the last one."""
        line = callers.line()
        self._screen.monitor.set_title(line)
        if sys.__stderr__ is not None:
            print(line, file=sys.__stderr__, flush=True)
        if self._screen.monitor.read_keystroke() == ESCAPE:
            KERNEL.pace.stepping = False


@functools.cache
def _signature(name: str) -> inspect.Signature:
    signature = inspect.signature(getattr(Graphics, name))
    return signature.replace(parameters=list(signature.parameters.values())[1:])


def _bound(name: str, given: tuple[Any, ...]) -> dict[str, Any]:
    return dict(_signature(name).bind(*given).arguments)


def _calls(
    name: str, arguments: dict[str, Any], method: Callable[..., Any]
) -> Iterator[dict[str, Any]]:
    """A call of arrays as calls of numbers; any other one as it is."""
    if name in _POLYGONS:
        corners = polygon_points(arguments["points"], arguments.get("flat"))
        if not isinstance(corners, list):
            rest = {key: value for key, value in arguments.items() if key not in ("points", "flat")}
            colors = {
                key: np.broadcast_to(value, len(corners)).tolist() for key, value in rest.items()
            }
            for number, points in enumerate(corners.tolist()):
                yield {"points": points, **{key: value[number] for key, value in colors.items()}}
            return
    elif name not in _NO_ARRAYS and any(map(is_array, arguments.values())):
        given = {key: value for key, value in arguments.items() if value is not None}
        for numbers in zip(*(one.tolist() for one in broadcast(**given)), strict=True):
            yield dict(zip(given, numbers, strict=True))
        return
    yield arguments


# The order of each call: from a screen and the call's arguments to a function of the pixels.


def _rows(screen: Graphics, given: dict[str, Any]) -> Order:
    return order.by_rows


def _points(screen: Graphics, given: dict[str, Any]) -> Order:
    """As the elements of the arrays come; of several on one place the last one counts."""
    dx, dy = screen._origin
    xs, ys, _ = broadcast(**given)
    last = {
        (x + dx, y + dy): at for at, (x, y) in enumerate(zip(xs.tolist(), ys.tolist(), strict=True))
    }
    return lambda x, y: np.argsort(
        [last[place] for place in zip(x.tolist(), y.tolist(), strict=True)]
    )


def _letters(screen: Graphics, given: dict[str, Any]) -> Order:
    return order.upwards if screen.settings.text.direction else order.by_columns


def _path(corners: Callable[[Graphics, dict[str, Any]], Any], fills: bool = False) -> Any:
    def of(screen: Graphics, given: dict[str, Any]) -> Order:
        dx, dy = screen._origin
        points: Points = [(int(x) + dx, int(y) + dy) for x, y in corners(screen, given)]
        width = screen.settings.line.thickness
        return lambda x, y: order.along(x, y, points, width, fills)

    return of


def _line(screen: Graphics, g: dict[str, Any]) -> Any:
    return (g["x1"], g["y1"]), (g["x2"], g["y2"])


def _lineto(screen: Graphics, g: dict[str, Any]) -> Any:
    return (screen.settings.x, screen.settings.y), (g["x"], g["y"])


def _linerel(screen: Graphics, g: dict[str, Any]) -> Any:
    x, y = screen.settings.x, screen.settings.y
    return (x, y), (x + g["dx"], y + g["dy"])


def _box(screen: Graphics, g: dict[str, Any]) -> Any:
    left, top, right, bottom = g["left"], g["top"], g["right"], g["bottom"]
    return (left, top), (right, top), (right, bottom), (left, bottom), (left, top)


def _polygon(screen: Graphics, g: dict[str, Any]) -> Any:
    corners = polygon_points(g["points"], g.get("flat"))
    return [*corners, corners[0]] if len(corners) else []


def _curve(by: Any, *, start: bool = False) -> Any:
    def of(screen: Graphics, g: dict[str, Any]) -> Order:
        dx, dy = screen._origin
        center = int(g["x"]) + dx, int(g["y"]) + dy
        rx = int(g["radius"] if "radius" in g else g["xradius"])
        xasp, yasp = screen.aspect
        ry = rx * xasp / yasp if "radius" in g else int(g["yradius"])
        more = (int(g.get("stangle", 0)),) if start else ()
        return lambda x, y: by(x, y, center, rx, ry, *more)

    return of


def _ellipse(screen: Graphics, g: dict[str, Any]) -> Order:
    whole_turn = abs(int(g["endangle"]) - int(g["stangle"])) >= 360
    by = _curve(order.by_quadrants) if whole_turn else _curve(order.by_angle, start=True)
    found: Order = by(screen, g)
    return found


def _flood(screen: Graphics, g: dict[str, Any]) -> Order:
    dx, dy = screen._origin
    seed = int(g["x"]) + dx, int(g["y"]) + dy
    return lambda x, y: order.spreading(x, y, seed)


_POLYGONS = {"drawpoly", "fillpoly"}
_NO_ARRAYS = {
    "putpixel",
    "putimage",
    "readimagefile",
    "outtext",
    "outtextxy",
    "cleardevice",
    "clearviewport",
}

_PIE = _curve(order.rim_last, start=True)

ORDERS: dict[str, Callable[[Graphics, dict[str, Any]], Order]] = {
    "putpixel": _points,
    **dict.fromkeys(("bar", "cleardevice", "clearviewport", "putimage", "readimagefile"), _rows),
    **dict.fromkeys(("outtext", "outtextxy"), _letters),
    **{"line": _path(_line), "lineto": _path(_lineto), "linerel": _path(_linerel)},
    **{"rectangle": _path(_box), "drawpoly": _path(_polygon)},
    **{"bar3d": _path(_box, True), "fillpoly": _path(_polygon, True)},
    **{"circle": _curve(order.by_octants), "arc": _curve(order.by_angle, start=True)},
    **{"ellipse": _ellipse, "fillellipse": _PIE, "pieslice": _PIE, "sector": _PIE},
    "floodfill": _flood,
}
"""Every call that sets pixels."""
