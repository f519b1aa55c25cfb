"""A picture takes its memory from what the one before left."""

import os
import platform
import subprocess
import sys

import pytest

PICTURES = """
import resource
import numpy as np
import bgi
from surfaces import surface

def faults():
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt

bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
counts = []
for picture in range(8):
    before = faults()
    surface(lambda x, y: np.sin(x * x + y * y), (-2.5, 2.5), (-2.5, 2.5), 400)
    counts.append(faults() - before)
print(min(counts))
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="speaks of glibc")
def test_no_picture_waits_for_new_pages() -> None:
    """Each took 1500 pages anew, a fifth of its time: `arrays.keep_freed_memory`."""
    environment = os.environ | {"BGI_MONITOR": "none"}
    done = subprocess.run(
        [sys.executable, "-c", PICTURES],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    assert int(done.stdout) < 100
