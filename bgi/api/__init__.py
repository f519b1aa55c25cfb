"""The façade: graphics.h's functions, written out. Each is one call on the current screen."""
