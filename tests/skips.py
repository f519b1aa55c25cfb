"""A test may be skipped only for a reason of this list, and only where that reason holds.

Any other skip is a failure. On a developer's machine a package may be missing; in CI (the variable
CI) what the extra `[test]` brings is there, and so nothing that could run is left out.
"""

import importlib.util
import os
import platform
import shutil
import sys
from collections.abc import Generator

import numpy as np
import pytest

from bgi.memory import sdl
from tools.pyodide import parts

IN_CI = bool(os.environ.get("CI"))
BROWSER = sys.platform == "emscripten"
WINDOWS, MACOS, LINUX = (sys.platform == name for name in ("win32", "darwin", "linux"))


def _no_program(name: str) -> bool:
    return shutil.which(name) is None


def _no_package(name: str) -> bool:
    return not IN_CI and importlib.util.find_spec(name) is None


REASONS = {
    "needs Xvfb": _no_program("Xvfb"),
    "needs xdotool": _no_program("xdotool"),
    "needs gcc": _no_program("gcc"),
    "needs import": _no_program("import"),  # ImageMagick's
    "needs setxkbmap": _no_program("setxkbmap"),
    "needs Chromium": IN_CI or _no_program("chromium"),  # a browser is no part of CI
    "needs Pyodide": IN_CI or not parts.cached(),  # python -m tools.site fetches it
    "needs pygame": not sdl.FOUND,
    "needs Pillow": _no_package("PIL"),
    "needs Hershey-Fonts": _no_package("HersheyFonts"),
    "needs shapely": _no_package("shapely"),
    "needs mypy": _no_package("mypy"),
    "needs hatchling": _no_package("hatchling"),
    "there are no processes": BROWSER,
    "there are no threads": BROWSER,
    "two mappings of a file share no memory": BROWSER,
    "floating point differs in the last bit": BROWSER,
    "argparse speaks otherwise": BROWSER,
    "no array is so large": BROWSER,
    "endless recursion through C ends Python": BROWSER,
    "Python is always at a prompt": BROWSER,
    "uses POSIX signals or fork": WINDOWS,
    "uses POSIX descriptors": WINDOWS,
    "this system makes no links": WINDOWS,
    "looks into /proc": not LINUX,
    "speaks of X11": not LINUX,
    "speaks of glibc": platform.libc_ver()[0] != "glibc",
    "there is always a display": WINDOWS or MACOS,
    "numpy 1 imports random itself": np.lib.NumpyVersion(np.__version__) < "2.0.0",
}

needs_pygame = pytest.mark.skipif(not sdl.FOUND, reason="needs pygame")


def unexpected(reason: str) -> str:
    """What is wrong with a skip for that reason; nothing: an empty text."""
    if reason not in REASONS:
        return f"skipped for a reason that tests/skips.py does not know: {reason}"
    return "" if REASONS[reason] else f"skipped here, where the reason does not hold: {reason}"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Turn an unexpected skip into a failure."""
    report = yield
    if report.skipped and not hasattr(report, "wasxfail"):
        assert isinstance(report.longrepr, tuple)
        if complaint := unexpected(report.longrepr[2].removeprefix("Skipped: ")):
            report.outcome, report.longrepr = "failed", complaint
    return report
