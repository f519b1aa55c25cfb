"""Calls that choose a style, and calls that ask for one."""

from bench import calls
from bench.arguments import always, in_turn
from bench.calls import Call
from bench.timing import Row

TABLE = [
    Call("setcolor", "setcolor", in_turn((1,), (2,))),
    Call("setbkcolor", "setbkcolor", in_turn((1,), (2,), count=10)),
    Call("setfillstyle", "setfillstyle", in_turn((1, 2), (7, 4))),
    Call("setlinestyle", "setlinestyle", in_turn((0, 0, 1), (0, 0, 3))),
    Call("setlinestyle, dashed", "setlinestyle", in_turn((3, 0, 1), (1, 0, 1))),
    Call("setwritemode", "setwritemode", in_turn((0,), (1,))),
    Call("settextstyle, 8x8", "settextstyle", in_turn((0, 0, 1), (0, 0, 2))),
    Call("settextstyle, TRIPLEX", "settextstyle", in_turn((1, 0, 4), (1, 0, 3), count=50)),
    Call("settextjustify", "settextjustify", in_turn((0, 2), (1, 1))),
    Call("setviewport", "setviewport", in_turn((0, 0, 639, 479, 1), (9, 9, 99, 99, 1))),
    Call("setpalette", "setpalette", in_turn((1, 5), (1, 1), count=50)),
    Call("setactivepage", "setactivepage", in_turn((1,), (0,))),
    Call("getmaxx", "getmaxx", always()),
    Call("getx", "getx", always()),
    Call("getcolor", "getcolor", always()),
    Call("graphresult", "graphresult", always()),
    Call("getfillsettings", "getfillsettings", always()),
    Call("getlinesettings", "getlinesettings", always()),
    Call("kbhit", "kbhit", always(count=50)),
]


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("settings", TABLE)
