"""Space and the way to the screen: transformations, the mapping, projections, fitting."""
