"""What every call rests on: its numbers, the table of modes, drivers, fonts and the result."""
