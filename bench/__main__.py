"""`python -m bench [calls] [surfaces] [monitor]`: what things cost. All of them unless named."""

import os
import sys

os.environ["BGI_MONITOR"] = "none"  # the report of the monitor opens a window all the same

from bench import calls, monitor, surfaces

REPORTS = {"calls": calls.report, "surfaces": surfaces.report, "monitor": monitor.report}

wanted = sys.argv[1:] or list(REPORTS)
unknown = [name for name in wanted if name not in REPORTS]
if unknown:
    sys.exit(f"bench: no {', '.join(unknown)}; there are {', '.join(REPORTS)}")
for name in wanted:
    REPORTS[name]()
