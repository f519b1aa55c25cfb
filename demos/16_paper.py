"""The paper's figures 3, 4 and 5, side by side.

    python demos/16_paper.py

What it shows: "A Very Simple Approach for 3-D to 2-D Mapping" drew four functions as meshes in
Turbo C, and two of them with colours in Java. Each figure is one call of `surfaces.surface`, which
fits itself to the viewport it is drawn in. Any key ends.
"""

from bgi import *
from surfaces import FIGURES, surface

MODE = (IBM8514, IBM8514LO)
CAPTION = 28
WAVES, RIPPLES, RIDGE, EGG_CRATE = FIGURES
# A column for each figure of the paper: its caption, its two functions, how they are drawn.
COLUMNS = (
    ("Figure 3: Turbo C", (WAVES, RIPPLES), "mesh"),
    ("Figure 4: Turbo C", (RIDGE, EGG_CRATE), "mesh"),
    ("Figure 5: Java", (WAVES, RIPPLES), "fill"),
)


def draw() -> None:
    """Six pictures, each in its viewport."""
    width, height = (getmaxx() + 1) // 3, (getmaxy() + 1 - CAPTION) // 2
    for column, (caption, figures, mode) in enumerate(COLUMNS):
        setviewport(0, 0, getmaxx(), getmaxy(), 1)
        setcolor(WHITE)
        outtextxy(column * width + (width - textwidth(caption)) // 2, 10, caption)
        for row, figure in enumerate(figures):
            left, top = column * width, CAPTION + row * height
            setviewport(left, top, left + width - 1, top + height - 1, 1)
            surface(
                figure.f,
                figure.x,
                figure.y,
                n=figure.n // 2 if mode == "mesh" else 120,
                mode=mode,
                zfrac=figure.zfrac,
                lines=(YELLOW if row else LIGHTGREEN, GREEN),
            )
            setcolor(WHITE)
            left = (width - textwidth(figure.name)) // 2
            outtextxy(left, height - 16, figure.name)
    setviewport(0, 0, getmaxx(), getmaxy(), 1)


def main() -> None:
    """Draw, and wait for a key."""
    initgraph(*MODE)
    draw()
    getch()


if __name__ == "__main__":
    main()
