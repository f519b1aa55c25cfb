"""Drawing systems a surface can be drawn on: the BGI, SVG, characters."""
