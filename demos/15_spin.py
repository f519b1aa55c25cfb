"""Turn a surface: three dimensions from a library that knows two.

    python demos/15_spin.py

What it shows: `surfaces.surface` draws z = f(x, y) with pixels only, 40,000 cells of it. A turn is
one matrix, made anew for each picture from two angles. Each picture is drawn on the page that is
not shown, and `swapbuffers` then shows it whole: that is why nothing flickers.

    1 2 3 4   the four functions of the paper      w m f b   wire, mesh, filled, both
    arrows    turn                                 space     start and stop
    Esc       end
"""

from dataclasses import dataclass
from math import radians

from bgi import *
from surfaces import FIGURES, compose, rotation, surface

MODE = (IBM8514, IBM8514LO)
ESC, SPACE = 27, ord(" ")
# What getch() returns for an arrow key after the 0.
LEFT, RIGHT, UP, DOWN = 75, 77, 72, 80
STEP = 5  # degrees that an arrow key turns
MODES = {ord("w"): "wire", ord("m"): "mesh", ord("f"): "fill", ord("b"): "fill+mesh"}
HELP = "1-4 function  w m f b style  arrows turn  space spin  Esc end"


@dataclass
class Scene:
    """What is on the screen, and how the keys change it."""

    figure: int = 1
    mode: str = "fill"
    spin: float = 0.0
    tilt: float = 0.0
    spinning: bool = True
    running: bool = True

    def press(self, key: int) -> None:
        """Obey one key; an arrow is a 0 and then a second code."""
        if key == 0:
            self.turn(getch())
        elif key in MODES:
            self.mode = MODES[key]
        elif ord("1") <= key < ord("1") + len(FIGURES):
            self.figure = key - ord("1")
        elif key == SPACE:
            self.spinning = not self.spinning
        elif key == ESC:
            self.running = False

    def turn(self, arrow: int) -> None:
        """Turn by one step."""
        if arrow == LEFT:
            self.spin -= STEP
        elif arrow == RIGHT:
            self.spin += STEP
        elif arrow == UP:
            self.tilt += STEP
        elif arrow == DOWN:
            self.tilt -= STEP

    def draw(self) -> None:
        """One picture, on the page that is not shown."""
        figure = FIGURES[self.figure]
        turn = compose(rotation("z", radians(self.spin)), rotation("y", radians(self.tilt)))
        cleardevice()
        setcolor(YELLOW)
        surface(
            figure.f,
            figure.x,
            figure.y,
            n=200,
            mode=self.mode,
            transform=turn,
            zfrac=figure.zfrac,
        )
        setcolor(WHITE)
        outtextxy(8, 8, f"z = {figure.name}   {self.mode}")
        outtextxy(8, getmaxy() - 15, HELP)


def draw() -> None:
    """One moment of the turn."""
    Scene(spin=30).draw()


def main() -> None:
    """Run until Esc."""
    initgraph(*MODE)
    scene = Scene()
    while scene.running:
        scene.draw()
        swapbuffers()
        if scene.spinning:
            scene.spin += 1
        # A spinning surface only looks whether a key waits; one at rest waits for a key.
        if kbhit() or not scene.spinning:
            scene.press(getch())


if __name__ == "__main__":
    main()
