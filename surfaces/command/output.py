"""Where a picture goes: a window to walk round it in, or a file of one of four kinds."""

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, replace
from pathlib import Path

from bgi import YELLOW, cleardevice, setcolor, writeimagefile
from surfaces.animation import progress, save_gif
from surfaces.command.parser import Order
from surfaces.explorer import Options, explore
from surfaces.explorer.screen import USUAL, open_screen
from surfaces.systems.characters import Text
from surfaces.systems.svg import Svg

PAGE = (78, 40)
"""Columns and rows of a text."""
MILLISECONDS = 50
"""How long a GIF shows each picture."""


def put_out(order: Order) -> None:
    """Do what a command line asks for."""
    if order.output is None:
        _open_window(order)
    else:
        WRITERS[order.kind](order, order.output)


def _open_window(order: Order) -> None:
    if order.monitor:
        os.environ["BGI_MONITOR"] = order.monitor
    explore(order.formula, order.size or USUAL, **asdict(order.options))


def _png(order: Order, file: Path) -> None:
    _hidden_screen(order)
    _page(order.formula, order.options)
    writeimagefile(file)


def _gif(order: Order, file: Path) -> None:
    """A full turn about z, in equal steps."""
    _hidden_screen(order)
    from tempfile import TemporaryDirectory  # late, as most orders need it never

    with TemporaryDirectory() as folder:
        save_gif(file, _turn(order, Path(folder)), MILLISECONDS)


def _turn(order: Order, folder: Path) -> Iterator[Path]:
    for number in progress(range(order.frames), "drawing"):
        angle = order.options.turn + 360 * number / order.frames
        _page(order.formula, replace(order.options, turn=angle, turns=True))
        picture = folder / f"{number}.png"
        writeimagefile(picture)
        yield picture


def _svg(order: Order, file: Path) -> None:
    picture = Svg(*order.size or USUAL)
    picture.setcolor(YELLOW)
    order.options.draw(order.formula, on=picture)
    picture.save(file)


def _txt(order: Order, file: Path) -> None:
    page = Text(*order.size or PAGE)
    order.options.draw(order.formula, on=page)
    file.write_text(f"{page}\n", encoding="utf-8")


def _hidden_screen(order: Order) -> None:
    """A screen that nobody sees."""
    os.environ["BGI_MONITOR"] = "none"
    open_screen(order.size or USUAL, order.options.dither)


def _page(text: str, options: Options) -> None:
    """Draw the surface on an empty page."""
    cleardevice()
    setcolor(YELLOW)
    options.draw(text)


WRITERS: Mapping[str, Callable[[Order, Path], None]] = {
    ".png": _png,
    ".gif": _gif,
    ".svg": _svg,
    ".txt": _txt,
}
