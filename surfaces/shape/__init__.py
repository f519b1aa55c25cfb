"""Shapes as arrays: grids, sheets, holes, contours, values for colours."""
