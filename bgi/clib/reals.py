"""The digits of real numbers, as printf and gcvt() write them: at most fifteen that count.

Each function takes a number without a sign, and whether the point stands also where nothing follows
it. What lies halfway between two roundings becomes the even one.
"""

DIGITS = 15
"""Significant digits of a double, whatever the precision; zeros follow."""


def fixed(number: float, precision: int, point: bool) -> str:
    """As %f: digits before and behind the point."""
    rounded = f"{number:.{DIGITS - 1}e}"
    if int(rounded.partition("e")[2]) + precision < DIGITS:
        digits = f"{number:.{precision}f}"
    else:
        from decimal import Decimal  # late, as it takes longer to import than all else here

        digits = f"{Decimal(rounded):.{precision}f}"
    return digits + "." if point and not precision else digits


def exponential(number: float, precision: int, point: bool) -> str:
    """As %e: one digit before the point, and an exponent of two digits or three."""
    mantissa, _, exponent = f"{number:.{min(precision, DIGITS - 1)}e}".partition("e")
    zeros = "0" * (precision - DIGITS + 1)
    return f"{mantissa}{zeros}{'.' if point and not precision else ''}e{exponent}"


def general(number: float, precision: int, point: bool) -> str:
    """As %g: %e for what is small or large, %f for others, without zeros at the end."""
    precision = precision or 1
    exponent = int(f"{number:.{min(precision, DIGITS) - 1}e}".partition("e")[2])
    if -4 <= exponent < precision:
        digits, power = fixed(number, precision - 1 - exponent, point), ""
    else:
        digits, _, power = exponential(number, precision - 1, point).partition("e")
        power = "e" + power
    if not point and "." in digits:
        digits = digits.rstrip("0").rstrip(".")
    return digits + power
