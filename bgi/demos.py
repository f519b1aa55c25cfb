"""The command `python -m bgi.demos` in a copy of the repository, where the demos lie beside `bgi`.

Installed, `bgi.demos` is that folder itself, and this file is left out.
"""

import runpy
from pathlib import Path

if __name__ == "__main__":
    runpy.run_path(str(Path(__file__).parents[1] / "demos"), run_name="__main__")
