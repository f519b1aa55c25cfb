"""From the tree to a typed one: everything that is wrong with a program is told here."""
