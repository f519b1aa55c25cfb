"""The libraries that calls are measured with: ours, SDL_bgi and pygame, each where it is installed.

A row says what is drawn once, in our arguments. Each library turns them into its own before the
clock runs: SDL_bgi wants polygons as flat lists, pygame has other functions altogether.
"""

import ctypes
import functools
import importlib
import os
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, NamedTuple, Protocol
from unittest import mock

import numpy as np

import bgi
from bench.timing import OURS, Arguments
from bgi.errors import BGIError
from bgi.memory.sdl import pygame

LIBRARY = "BENCH_SDL_BGI"
"""The environment variable that names SDL_bgi's library, if the system does not find it."""
SIZE = 640, 480


class Picture(NamedTuple):
    """Stands in arguments for an image of that many pixels squared, as the library has them."""

    size: int


class Library(Protocol):
    """What can draw."""

    name: str
    functions: Any
    """An object with the functions of graphics.h, for whole programs; None: it has them not."""

    def reset(self) -> None:
        """Clear the screen, with all settings as at the beginning."""

    def function(self, name: str) -> Callable[..., object] | None:
        """What does what the function of that name of graphics.h does; None: nothing does."""

    def arguments(self, name: str, many: Arguments) -> Arguments:
        """The arguments that `function` takes."""


def open_mode(driver: int, mode: int, colors: int) -> None:
    """Have our screen in a mode: one of so many colours stays as it is."""
    try:
        is_open = bgi.getmaxcolor() == colors - 1
    except BGIError:
        is_open = False
    if not is_open:
        bgi.initgraph(driver, mode)


class Ours:
    """This project, without a window."""

    name = OURS
    functions: Any = bgi

    def reset(self) -> None:
        open_mode(bgi.VGA, bgi.VGAHI, 16)
        bgi.graphdefaults()
        bgi.setwritemode(bgi.COPY_PUT)
        bgi.setactivepage(0)
        bgi.cleardevice()

    def function(self, name: str) -> Callable[..., object]:
        found: Callable[..., object] = getattr(bgi, name)
        return found

    def arguments(self, name: str, many: Arguments) -> Arguments:
        if name != "putimage":
            return many
        return [(x, y, _image(picture.size), operator) for x, y, picture, operator in many]


@functools.cache
def _image(size: int) -> bgi.Image:
    return bgi.Image(np.ones((size, size), np.uint8))


class SdlBgi:
    """SDL_bgi through its Python module, in its fast mode: it draws without showing."""

    name = "SDL_bgi"

    def __init__(self, module: Any) -> None:
        self.module = module
        module.initgraph(module.SDL, module.SDL_640x480)  # other numbers than ours
        module.sdlbgifast()
        polygons = {name: self._of_points(name) for name in ("drawpoly", "fillpoly")}
        self.functions: Any = SimpleNamespace(**{**vars(module), **polygons})

    def reset(self) -> None:
        self.module.graphdefaults()
        self.module.setwritemode(bgi.COPY_PUT)
        self.module.setlinestyle(bgi.SOLID_LINE, 0, bgi.NORM_WIDTH)
        self.module.setactivepage(0)
        self.module.cleardevice()

    def function(self, name: str) -> Callable[..., object]:
        found: Callable[..., object] = getattr(self.module, name)
        return found

    def arguments(self, name: str, many: Arguments) -> Arguments:
        if name in ("drawpoly", "fillpoly"):
            return [(len(points), _flat(points)) for (points,) in many]
        if name == "getimage":
            return [(*box, self._image(box[2] - box[0] + 1)) for box in many]
        if name == "putimage":
            return [(x, y, self._image(size), operator) for x, y, (size,), operator in many]
        return many

    def _image(self, size: int) -> Any:
        box = 0, 0, size - 1, size - 1
        buffer = ctypes.create_string_buffer(self.module.imagesize(*box))
        self.module.setfillstyle(bgi.SOLID_FILL, bgi.BLUE)
        self.module.bar(*box)
        self.module.getimage(*box, buffer)
        return buffer

    def _of_points(self, name: str) -> Callable[[Any], None]:
        function = self.function(name)

        def polygon(points: Any) -> None:
            function(len(points), _flat(points))

        return polygon


def _flat(points: Any) -> list[int]:
    return [number for point in points for number in point]


class Pygame:
    """pygame itself, on a surface of 8 bits: no styles, no operators, no rules of Borland's."""

    name = "pygame"
    functions: Any = None

    def __init__(self) -> None:
        self.surface = pygame.Surface(SIZE, depth=8)
        pygame.font.init()
        self.font = pygame.font.Font(None, 16)

    def reset(self) -> None:
        self.surface.fill(0)

    def function(self, name: str) -> Callable[..., object] | None:
        return EQUIVALENTS[name].function(self) if name in EQUIVALENTS else None

    def arguments(self, name: str, many: Arguments) -> Arguments:
        return [EQUIVALENTS[name].arguments(self, *each) for each in many]

    def text(self, place: tuple[int, int], letters: str) -> None:
        """Letters, as pygame's users write them."""
        self.surface.blit(self.font.render(letters, False, (255, 255, 255)), place)

    def copy(self, box: tuple[int, int, int, int]) -> pygame.Surface:
        """What getimage does."""
        return self.surface.subsurface(box).copy()


class Equivalent(NamedTuple):
    """A function of pygame that does what one of graphics.h does, and its arguments from those."""

    function: Callable[[Pygame], Callable[..., object]]
    arguments: Callable[..., tuple[Any, ...]]


COLOR = 15


def _box(left: int, top: int, right: int, bottom: int) -> tuple[int, int, int, int]:
    return left, top, right - left + 1, bottom - top + 1


def _around(x: int, y: int, rx: int, ry: int) -> tuple[int, int, int, int]:
    return x - rx, y - ry, 2 * rx + 1, 2 * ry + 1


EQUIVALENTS = {
    "putpixel": Equivalent(
        lambda p: p.surface.set_at, lambda p, x, y, c: ((int(x), int(y)), int(c))
    ),
    "getpixel": Equivalent(lambda p: p.surface.get_at_mapped, lambda p, *place: (place,)),
    "line": Equivalent(
        lambda p: pygame.draw.line,
        lambda p, x1, y1, x2, y2: (p.surface, COLOR, (x1, y1), (x2, y2)),
    ),
    "rectangle": Equivalent(
        lambda p: pygame.draw.rect, lambda p, *ends: (p.surface, COLOR, _box(*ends), 1)
    ),
    "drawpoly": Equivalent(
        lambda p: pygame.draw.lines, lambda p, points: (p.surface, COLOR, False, points)
    ),
    "circle": Equivalent(
        lambda p: pygame.draw.circle, lambda p, x, y, r: (p.surface, COLOR, (x, y), r, 1)
    ),
    "fillellipse": Equivalent(
        lambda p: pygame.draw.ellipse, lambda p, *oval: (p.surface, COLOR, _around(*oval))
    ),
    "fillpoly": Equivalent(
        lambda p: pygame.draw.polygon, lambda p, points: (p.surface, COLOR, points)
    ),
    "bar": Equivalent(lambda p: p.surface.fill, lambda p, *ends: (COLOR, _box(*ends))),
    "outtextxy": Equivalent(lambda p: p.text, lambda p, x, y, letters: ((x, y), letters)),
    "cleardevice": Equivalent(lambda p: p.surface.fill, lambda p: (0,)),
    "getimage": Equivalent(lambda p: p.copy, lambda p, *ends: (_box(*ends),)),
    "putimage": Equivalent(
        lambda p: p.surface.blit,
        lambda p, x, y, picture, _: (p.copy((0, 0, picture.size, picture.size)), (x, y)),
    ),
}


def sdl_bgi() -> SdlBgi | None:
    """SDL_bgi, if its module and its library are installed.

    The module loads a library by a name, and ends the interpreter where there is none. So it is
    given, while it is imported, the one that `BENCH_SDL_BGI` names. It draws into no window.
    """
    path = os.environ.get(LIBRARY)
    load = functools.partial(_load, ctypes.CDLL, path) if path else ctypes.CDLL
    driver = {"SDL_VIDEODRIVER": "dummy"}
    with mock.patch.dict(os.environ, driver), mock.patch.object(ctypes, "CDLL", load):
        try:
            return SdlBgi(importlib.import_module("sdl_bgi"))
        except (ImportError, SystemExit):
            return None


def _load(load: Callable[[str], object], path: str, name: str) -> object:
    return load(path if "SDL_bgi" in name else name)


@functools.cache
def libraries() -> dict[str, Library | None]:
    """All that calls are measured with, by name; None: not installed."""
    return {OURS: Ours(), SdlBgi.name: sdl_bgi(), Pygame.name: Pygame()}
