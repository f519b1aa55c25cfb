"""From words to the tree of a program, as it is written."""
