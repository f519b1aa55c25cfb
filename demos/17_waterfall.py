"""A waterfall of spectra: data, not a formula.

    python demos/17_waterfall.py

What it shows: `surfaces.surface` takes an array of heights as well as a function. Each picture one
more spectrum flows in at the front and one leaves at the back; `mode="waterfall"` draws only the
lines along the frequencies, and hides what lies behind a peak. Space stops and starts, m changes
the mode, Esc ends.
"""

import numpy as np
from numpy.typing import NDArray

from bgi import *
from surfaces import surface

MODE = (IBM8514, IBM8514LO)
ESC, SPACE = 27, ord(" ")
MODES = ("waterfall", "mesh", "fill+mesh", "fill")
SPECTRA = 50
FREQUENCY = np.linspace(0, 8, 161)
Spectra = NDArray[np.float64]


def spectrum(time: int) -> Spectra:
    """Two tones that glide past each other, a third that comes and goes, and a little noise."""
    loudness = np.random.default_rng(time).uniform(0, 0.06, len(FREQUENCY))
    for tone, loud in (
        (4 + 2.8 * np.sin(time / 14), 1.0),
        (4 + 2.3 * np.cos(time / 23), 0.7),
        (6.5, 0.55 * np.sin(time / 9) ** 2),
    ):
        loudness += loud * np.exp(-(((FREQUENCY - tone) / 0.22) ** 2))
    return loudness


def flow(start: int) -> Spectra:
    """The spectra from a time on, the last one in front."""
    return np.stack([spectrum(time) for time in range(start, start + SPECTRA)])


def show(spectra: Spectra, mode: str = "waterfall") -> None:
    """One picture, on the page as it is."""
    setcolor(LIGHTCYAN)
    surface(
        spectra,
        x=(0, SPECTRA / 10),
        y=(float(FREQUENCY[0]), float(FREQUENCY[-1])),
        z=(0, 1.6),
        mode=mode,
        every=1 if mode == "waterfall" else 4,
        axes=("s", "kHz", "V"),
        title="Two tones pass",
        ramp="heat",
    )


def draw() -> None:
    """One moment."""
    show(flow(30))


def main() -> None:
    """Flow until Esc."""
    initgraph(*MODE)
    time = 0
    place = 0  # in MODES
    flowing = True
    key = 0
    while key != ESC:
        cleardevice()
        show(flow(time), MODES[place])
        swapbuffers()
        if flowing:
            time += 1
        # A waterfall that flows only looks whether a key waits; one at rest waits for a key.
        if kbhit() or not flowing:
            key = getch()
            if key == SPACE:
                flowing = not flowing
            elif key == ord("m"):
                place = (place + 1) % len(MODES)


if __name__ == "__main__":
    main()
