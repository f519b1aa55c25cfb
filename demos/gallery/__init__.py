"""What the demos have in common: the list of them, the menu, pages to leaf through."""
