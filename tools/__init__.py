"""What makes files that are committed: the documentation's pictures and pages, and the fonts."""
