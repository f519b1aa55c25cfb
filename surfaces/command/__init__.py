"""The command `python -m surfaces`: what may be typed, and the files it can write."""
