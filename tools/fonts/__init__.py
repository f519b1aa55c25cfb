"""What made the stroked fonts that ship with the library; the library itself never needs it."""
