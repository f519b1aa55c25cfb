"""Text: the built-in 8x8 font, and how a string becomes cells."""
