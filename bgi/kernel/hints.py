"""What may have been meant: added to the words of an error, for those that beginners make."""

import inspect
import re
import sys
from types import FunctionType, TracebackType

from bgi import constants

COLORS = {"color", "fill", "border"}
"""What arguments are called that are a colour of the screen."""

CLOSE = 0.8  # from 0 to 1: how much a word must be like the name of a constant

LONGEST = 40
"""Characters of a text that may be a constant in quotes: it is compared with each of them."""

_NAMES = {name.replace("_", ""): name for name in vars(constants) if name.isupper()}


def for_argument(name: str, value: object) -> str:
    """A hint for an argument that is no number; empty if there is none."""
    if isinstance(value, str) and len(value) <= LONGEST:
        word = re.sub(r"[\W_]", "", value).upper()
        import difflib  # late, as most programs make no mistake

        close = difflib.get_close_matches(word, _NAMES, 1, CLOSE)
        if close:
            return f"; did you mean {_NAMES[close[0]]}, without quotes?"
    if name in COLORS and isinstance(value, tuple) and len(value) == 3:
        return f"; in a window of initwindow() a mixture is COLOR{value}"
    if name in COLORS and isinstance(value, str):
        return "; a colour is a number, such as RED"
    return ""


def add_to(error: BaseException, traceback: TracebackType | None) -> None:
    """Add a note to an error that the program does not catch, where we know what may help."""
    hint = ""
    if isinstance(error, TypeError):
        hint = _for_a_wrong_call(str(error), traceback)
    elif isinstance(error, ImportError) and error.name in ("bgi", "surfaces"):
        hint = hidden(error.name)
    if hint and hint not in getattr(error, "__notes__", ()):
        error.add_note(hint)


def hidden(package: str) -> str:
    """What hides one of our packages, if a single file does: a program that is called so."""
    module = sys.modules.get(package)
    if module is None or hasattr(module, "__path__"):
        return ""
    return f"{module.__file__} hides the package {package}: give that file another name"


def _for_a_wrong_call(message: str, traceback: TracebackType | None) -> str:
    """How a function of ours is called, if that is what the program got wrong."""
    found = re.match(r"(\w+)\(\) (missing|takes|got)", message)
    while traceback is not None and traceback.tb_next is not None:
        traceback = traceback.tb_next
    if found is None or traceback is None:
        return ""
    name = found[1]
    function = traceback.tb_frame.f_globals.get(name, getattr(sys.modules["bgi"], name, None))
    if not isinstance(function, FunctionType) or not function.__module__.startswith("bgi."):
        return ""
    parameters = inspect.signature(function).parameters
    written = ", ".join(str(one.replace(annotation=one.empty)) for one in parameters.values())
    points = "; a point is two numbers, x and y, and no pair" if "y" in written else ""
    return f"{name}({written}): {_summary(function)}{points}"


def _summary(function: FunctionType) -> str:
    """The first paragraph of a docstring, in one line."""
    paragraph = (inspect.getdoc(function) or "").partition("\n\n")[0]
    return " ".join(paragraph.split()).removesuffix(".")
