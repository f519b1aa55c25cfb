"""The explorer: a window to walk round a surface in, by keys and mouse.

    from surfaces import explore

    explore("sin(x*y)/2")

`python -m surfaces` opens it, too. It is a program, not a part of the plotter: it asks for keys,
looks at the mouse and swaps pages, and draws by `surface()` as any other program does.

    options   what can be set: ranges, turn, view, mode, colours, ...
    dials     how an option is turned a step further      keys      which key turns which
    canvas    the surface and the cross-hair              panel     the lines below it
    editor    where a formula is typed                    status    how the options stand
    motion    what the mouse did                          helppage  all the keys
    saving    pictures on the disk                        screen    the mode that is drawn in
    explorer  all of these put together                   loop      draw, show, wait
"""

from surfaces.explorer.explorer import EXAMPLES, Explorer
from surfaces.explorer.loop import explore
from surfaces.explorer.options import Options

__all__ = ["EXAMPLES", "Explorer", "Options", "explore"]
