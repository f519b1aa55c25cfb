"""WinBGIm's names: windows of any size, colours of any mixture, the mouse over the window."""

from __future__ import annotations

from typing import Any

import bgi
from bgi import current
from bgi.turboc.runtime.binding import characters
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.scripted import Scripted
from bgi.turboc.runtime.session import Session

DIRECT = "void swapbuffers(void); void closewindow(int number);"
"""Those that C and Python call alike."""

PLAIN = """
long COLOR(int red, int green, int blue); int IS_BGI_COLOR(long color);
int IS_RGB_COLOR(long color); long converttorgb(long color); int RED_VALUE(long color);
int GREEN_VALUE(long color); int BLUE_VALUE(long color); int getmaxwidth(void);
int getmaxheight(void); int getwindowwidth(void); int getwindowheight(void);
int getcurrentwindow(void); void setcurrentwindow(int number); int getactivepage(void);
int getvisualpage(void);
"""
"""The same, which leave no line in the trace."""

OTHERS = """
int initwindow(int width, int height, ...); void readimagefile(text name, ...);
void writeimagefile(text name, ...); int mousex(void); int mousey(void);
int ismouseclick(int kind); void getmouseclick(int kind, int &x, int &y);
void clearmouseclick(int kind); void setmousequeuestatus(int kind, ...);
void registermousehandler(int kind, void *handler); int showerrorbox(text message);
"""

CONSTANTS = {
    **{"KEY_HOME": 71, "KEY_UP": 72, "KEY_PGUP": 73, "KEY_LEFT": 75, "KEY_CENTER": 76},
    **{"KEY_RIGHT": 77, "KEY_END": 79, "KEY_DOWN": 80, "KEY_PGDN": 81, "KEY_INSERT": 82},
    **{"KEY_DELETE": 83, **{f"KEY_F{number}": 58 + number for number in range(1, 11)}},
}

_LEFT_DOWN, _RIGHT_DOWN = bgi.WM_LBUTTONDOWN, bgi.WM_RBUTTONDOWN


class WindowLibrary:
    """The functions of OTHERS for one program."""

    def __init__(self, program: Session) -> None:
        self._program, self._pc = program, program.pc

    def _note(self, name: str, given: tuple[Any, ...]) -> None:
        if self._program.trace:
            self._program.trace.call(name, given)

    def initwindow(self, width: int, height: int, *more: Any) -> int:
        title = characters(more[0]).decode("cp437") if more and more[0] else "Windows BGI"
        double = bool(more[3]) if len(more) > 3 else False
        number = bgi.initwindow(width, height, title, dbflag=double)
        self._note("initwindow", (width, height))
        return number

    def readimagefile(self, name: Any, *box: int) -> None:
        """A picture of the program's folder; without one nothing happens."""
        written = characters(name)
        self._note("readimagefile", (written,))
        path = self._program.folder.path(written.decode("cp437"), writing=False)
        if path is not None:
            bgi.readimagefile(path, *box)

    def writeimagefile(self, name: Any, *box: int) -> None:
        written = characters(name)
        self._note("writeimagefile", (written,))
        path = self._program.folder.path(written.decode("cp437"), writing=True)
        if path is not None:
            bgi.writeimagefile(path, *box[:4])

    # The mouse

    def mousex(self) -> int:
        return self._pc.mouse()[1] if isinstance(self._pc, Scripted) else bgi.mousex()

    def mousey(self) -> int:
        return self._pc.mouse()[2] if isinstance(self._pc, Scripted) else bgi.mousey()

    def ismouseclick(self, kind: int) -> int:
        if not isinstance(self._pc, Scripted):
            return int(bgi.ismouseclick(kind))
        buttons = self._pc.mouse()[0]
        return int((kind, buttons) in ((_LEFT_DOWN, 1), (_RIGHT_DOWN, 2)))

    def getmouseclick(self, kind: int, x: Pointer, y: Pointer) -> None:
        if isinstance(self._pc, Scripted):
            place = self._pc.mouse(look=False)[1:]
        else:
            place = bgi.getmouseclick(kind)
        x.memory[x.at], y.memory[y.at] = place

    def clearmouseclick(self, kind: int) -> None:
        if not isinstance(self._pc, Scripted):
            bgi.clearmouseclick(kind)

    def setmousequeuestatus(self, kind: int, *status: int) -> None:
        bgi.setmousequeuestatus(kind, bool(status[0]) if status else True)

    def registermousehandler(self, kind: int, handler: Any) -> None:
        if current.is_open():
            bgi.registermousehandler(kind, handler)

    def showerrorbox(self, message: Any) -> int:
        self._program.print(characters(message) + b"\n")
        return 0
