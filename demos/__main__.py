"""The command `python -m demos`; installed, `python -m bgi.demos`."""

import sys

from gallery.foreign import explain

try:
    from gallery.command import main
except ImportError as error:
    sys.exit(f"demos: {explain(error)}")

sys.exit(main(prog=f"python -m {__package__ or 'bgi.demos'}"))
