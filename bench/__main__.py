"""`python -m bench`: what things cost, with us and with our peers."""

import os

os.environ["BGI_MONITOR"] = "none"  # the report of the monitor opens a window all the same

from bench.command import main

main()
