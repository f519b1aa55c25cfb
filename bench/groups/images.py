"""Images."""

from bench import calls
from bench.arguments import boxes, within
from bench.calls import Call
from bench.libraries import Picture
from bench.timing import Row

TABLE = [
    Call("getimage 16x16", "getimage", boxes(16, 16)),
    Call("getimage 100x100", "getimage", boxes(100, 100)),
    *(
        Call(
            f"putimage {size}x{size}{label}",
            "putimage",
            within(size, size, Picture(size), op),
            plain=op == 0,
        )
        for size in (16, 100)
        for label, op in (("", 0), (", XOR", 1), (", NOT", 4))
    ),
    Call("imagesize", "imagesize", boxes(100, 100)),
]


def rows() -> list[Row]:
    """The rows of this group."""
    return calls.rows("images", TABLE)
