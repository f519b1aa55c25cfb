"""What made the files that ship with the library; the library itself never needs it."""
