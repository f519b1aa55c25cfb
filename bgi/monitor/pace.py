"""How often a monitor looks at the card."""

import math
import os

RATE = 60  # pictures a second at most, unless BGI_RATE says otherwise

# Seconds.
IDLE_FRAME = 1 / 30  # between two looks at a card that does not change
IDLE_AFTER = 0.5  # without event, order or picture, until a monitor is idle
FACTS_SECONDS = 0.5  # between two questions about the program's screen, while the board is shown
LATE = 0.002  # by which a wait may end late: the next picture makes up for it


def frame_seconds() -> float:
    """The time from one picture to the next."""
    try:
        rate = float(os.environ.get("BGI_RATE", RATE))
    except ValueError:
        rate = RATE
    return 1 / (max(rate, 1) if math.isfinite(rate) else RATE)
