"""Demos: small programs that show what graphics.h can do, in the order of their numbers.

A demo is a program: `python demos/02_ball.py` runs it. Its docstring begins with three paragraphs,
which the gallery (`python -m demos`) shows: a summary of one line, the command that runs it, and
what it shows. All but the first, plain ones have

    MODE     driver and mode, as initgraph() takes them
    draw()   draws its representative picture on the current page; also in VGAHI, for the menu
    main()   opens the screen with initgraph(*MODE) and runs until a key ends it

None calls closegraph(): the window closes when a program ends, and the gallery goes on in it.
"""

import sys
from pathlib import Path

# A demo finds its helpers, in gallery/, beside it: as Python does for a program that it runs.
sys.path.insert(0, str(Path(__file__).parent))
