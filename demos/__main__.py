"""The command `python -m demos`; installed, `python -m bgi.demos`."""

import sys

from gallery.command import main

sys.exit(main(prog=f"python -m {__package__ or 'bgi.demos'}"))
