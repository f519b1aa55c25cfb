"""C's whole numbers: in so many bits."""


def signed(value: int, bits: int) -> int:
    """What is left of a number in so many bits, the first of which is the sign."""
    half = 1 << bits - 1
    return (value + half) % (2 * half) - half


def unsigned(value: int, bits: int) -> int:
    """A number without a sign; a negative one as its bits, of twice as many where it needs them."""
    while value < -1 << bits - 1:
        bits *= 2
    return value if value >= 0 else value + (1 << bits)
