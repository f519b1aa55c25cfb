"""Video memory: what a pixel is, where it lies and how it looks."""
