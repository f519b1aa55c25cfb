"""From the typed tree to Python that a person would have written."""
