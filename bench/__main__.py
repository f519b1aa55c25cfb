"""`python -m bench`: what the calls cost, without a window."""

import os

os.environ["BGI_MONITOR"] = "none"

from bench import calls

calls.report()
