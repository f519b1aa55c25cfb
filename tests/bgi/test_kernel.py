"""What the kernel keeps beyond any screen. (Its drivers: test_drivers; its fonts: test_text.)"""

import bgi
from bgi.kernel.state import KERNEL


def test_a_reset_makes_everything_new():
    """What a test leaves in the kernel, the next one does not find."""
    bgi.installuserdriver("D")
    bgi.installuserfont("F")
    bgi.setgraphbufsize(1)
    bgi.dos.srand(7)
    KERNEL.result.set(bgi.grError)
    KERNEL.reset()
    assert bgi.graphresult() == 0
    assert (bgi.installuserdriver("E"), bgi.installuserfont("G")) == (16, 11)
    assert bgi.setgraphbufsize(1) == 4096
    assert bgi.dos.rand() == 346


def test_buffers():
    assert bgi.setgraphbufsize(1000) == 4096
    assert bgi.setgraphbufsize(4096) == 1000
    block = bgi._graphgetmem(100)
    assert len(block) == 100
    bgi._graphfreemem(block, 100)
