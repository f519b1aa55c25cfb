"""Build the site in which every program runs in the page: static files, for any host.

    python -m tools.site [folder] [--numpy WHEEL]
    python -m http.server -d site

Python for the browser and its numpy are fetched once, by npm and pip: `tools.pyodide.parts`.
"""

import argparse
import sys
from pathlib import Path

from tools.pyodide import parts
from tools.site.build import build

ROOT = Path(__file__).parents[2]


def main() -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(prog="python -m tools.site", description="Build the site.")
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "site")
    parser.add_argument("--numpy", type=Path, metavar="WHEEL", help="Pyodide's own, for example")
    options = parser.parse_args()
    try:
        bytes_ = build(options.folder, options.numpy or parts.wheel(parts.NUMPY))
    except parts.Missing as error:
        print(f"tools.site: {error}", file=sys.stderr)
        return 1
    print(f"{options.folder}: a first visit loads {bytes_ / 1e6:.1f} MB at most")
    return 0


if __name__ == "__main__":
    sys.exit(main())
