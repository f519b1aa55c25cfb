"""Type any formula and walk round its surface.

    python demos/20_explore.py

What it shows: a whole program in one call. `surfaces.explore` opens a window on the surface of a
formula; arrows and mouse turn it, a read-out tells the point (x, y, z) under the mouse, and F1
shows all the keys. `Explorer` is what it is made of: give it keys, and let it draw.
"""

from bgi import *
from surfaces import Explorer, explore

MODE = (IBM8514, IBM8514LO)


def draw() -> None:
    """A surface with the cross-hair on it."""
    Explorer("sin(2*r)*cos(theta*2)").draw()


def main() -> None:
    """Explore until Esc."""
    explore("sin(x*y)/2")


if __name__ == "__main__":
    main()
