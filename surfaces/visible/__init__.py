"""What can be seen of a shape: orders of drawing, the floating horizon, the z-buffer, picking."""
