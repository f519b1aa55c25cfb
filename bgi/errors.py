"""The exceptions of the package.

What Borland answered with a code is a code here too: `graphresult()` hands it out. A `BGIError` is
raised where Borland's library could only have crashed, hung or ended the program.
"""

import reprlib


class _Short(reprlib.Repr):
    """Texts of values: never long, and never an error."""

    def __init__(self) -> None:
        super().__init__()
        self.maxstring = self.maxother = 60

    def repr_int(self, x: int, level: int) -> str:
        """A whole number, unless Python would refuse to write that many digits."""
        bits = x.bit_length()
        return repr(x) if bits <= 256 else f"<a whole number of {bits} bits>"


def brief(value: object) -> str:
    """A value as messages show it: at once, however long its own text would be."""
    return f"{_SHORT.repr(value):.60}"


_SHORT = _Short()


class BGIError(RuntimeError):
    """A call that cannot be carried out: no graphics mode, no window, no key to wait for."""


class GraphicsError(BGIError):
    """What graphresult() would report, raised at once: strict() asks for it.

    `function` is the call's name, `arguments` what was given by name, `code` Borland's error code.
    """

    def __init__(
        self, function: str, arguments: dict[str, object], code: int, message: str, why: str = ""
    ) -> None:
        given = ", ".join(f"{name}={brief(value)}" for name, value in arguments.items())
        super().__init__(f"{function}({given}): {message} ({code}){why and ': '}{why}")
        self.function = function
        self.arguments = arguments
        self.code = code


class BGIWarning(UserWarning):
    """A call that C would have taken, and that can hardly mean what it says."""


class WindowClosed(BGIError):
    """The user closed the window; raised by the program's next call.

    A program that does not catch it ends with one line and exit status 0: it made no error.
    """

    def _render_traceback_(self) -> list[str]:
        """What a notebook shows in place of a traceback."""
        return [f"bgi: {self}"]


class TimeIsUp(WindowClosed):
    """The end has come that BGI_AFTER plans."""

    def __init__(self, seconds: float) -> None:
        super().__init__(f"ended after {seconds:g} s, as planned")


class NobodyThere(WindowClosed):
    """The program waits for a key that nobody can press, since there is no window."""
