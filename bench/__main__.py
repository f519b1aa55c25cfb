"""`python -m bench [calls] [surfaces]`: what things cost, without a window. Both unless named."""

import os
import sys

os.environ["BGI_MONITOR"] = "none"

from bench import calls, surfaces

REPORTS = {"calls": calls.report, "surfaces": surfaces.report}

wanted = sys.argv[1:] or list(REPORTS)
unknown = [name for name in wanted if name not in REPORTS]
if unknown:
    sys.exit(f"bench: no {', '.join(unknown)}; there are {', '.join(REPORTS)}")
for name in wanted:
    REPORTS[name]()
