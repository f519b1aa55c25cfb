"""Class Strict: stands before a screen in strict mode, and refuses what the screen would swallow.

What Borland's functions report is an exception already in `Result.set`. They do not report a colour
that the mode does not have, nor a flood that runs out over the screen: here these are errors of the
same kind. Nothing of this is there while strict mode is off.
"""

import inspect
from functools import cache
from typing import Any

import numpy as np

from bgi.constants import grError
from bgi.errors import brief
from bgi.graphics import Graphics
from bgi.kernel.arguments import Numbers, broadcast, is_array, whole, whole_array
from bgi.kernel.hints import COLORS
from bgi.kernel.state import KERNEL
from bgi.memory import rgb

HARDWARE = {"setpalette"}
"""Whose colour is another one: a number that the hardware understands."""


class Strict:
    """Everything that a screen is; calls with a colour look at it first."""

    def __init__(self, screen: Graphics) -> None:
        self._screen = screen

    def __getattr__(self, name: str) -> Any:
        value = getattr(self._screen, name)
        signature = _signature(name)
        if signature is None:
            return value

        def call(*given: Any) -> Any:
            for parameter, color in signature.bind(*given).arguments.items():
                if parameter in COLORS and color is not None:
                    self._look_at(parameter, color, background=name == "setbkcolor")
            return value(*given)

        return call

    def floodfill(self, x: Numbers, y: Numbers, border: Numbers) -> None:
        """Fill areas that have a border."""
        self._look_at("border", border)
        pixels = self._screen.page.array
        before = pixels.copy()
        for one in np.stack(broadcast(x=x, y=y, border=border), axis=-1).tolist():
            if self._screen._overflows(*one):
                pixels[:] = before  # as the areas before it in the same call were filled
                reached = f"the area around {one[0]}, {one[1]} reaches all sides of the viewport"
                KERNEL.result.set(
                    grError, f"{reached}: no outline in color {brief(one[2])} is closed"
                )
            self._screen.floodfill(*one)

    def _look_at(self, name: str, color: Numbers, background: bool = False) -> None:
        numbers = (
            whole_array(name, color).ravel().tolist() if is_array(color) else [whole(name, color)]
        )
        mode = self._screen.mode
        last = max(mode.maxcolor, 15) if background else mode.maxcolor
        window = mode.pixel_bytes == 4
        for number in numbers:
            if not (0 <= number <= last or (window and number >> 24 == rgb.TAG >> 24)):
                others = " and COLOR(red, green, blue)" if window else ""
                KERNEL.result.set(
                    grError, f"there is no {name} {brief(number)}, only 0 to {last}{others}"
                )


@cache
def _signature(name: str) -> inspect.Signature | None:
    """The signature of a method that takes a colour; None for anything else of a screen."""
    method = getattr(Graphics, name, None)
    if name in HARDWARE or not inspect.isfunction(method):
        return None
    signature = inspect.signature(method)
    parameters = list(signature.parameters.values())[1:]  # without self
    takes_color = any(parameter.name in COLORS for parameter in parameters)
    return signature.replace(parameters=parameters) if takes_color else None
