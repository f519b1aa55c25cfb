"""Run the tests in Pyodide, on node: as `python -m pytest`, in a browser's Python.

    python -m tools.pyodide [arguments of pytest]

What cannot pass there is listed in tests/browser.py.
"""

import shutil
import subprocess
import sys
from pathlib import Path

from tools.pyodide import parts

ROOT = Path(__file__).parents[2]


def main(arguments: list[str]) -> int:
    """Run them; returns pytest's exit status."""
    try:
        wheels = [*map(parts.wheel, (parts.NUMPY, parts.PILLOW)), *parts.test_wheels()]
        core = parts.core()
    except parts.Missing as error:
        print(f"tools.pyodide: {error}", file=sys.stderr)
        return 1
    node = shutil.which("node")
    if node is None:
        print("tools.pyodide: node is not installed", file=sys.stderr)
        return 1
    runner = Path(__file__).with_name("tests.mjs")
    command = [node, runner, core, ROOT, *wheels, "--", *PYTEST, *(arguments or ["tests"])]
    return subprocess.run([*map(str, command)]).returncode


# pyproject.toml's, as far as they hold there: nothing runs beside the tests or ends them.
PYTEST = (
    *("-c", "/dev/null", "--rootdir", "/repository", "-p", "no:cacheprovider", "-q"),
    *("-o", "filterwarnings=error", "-o", "pythonpath=/repository/demos"),
)

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
