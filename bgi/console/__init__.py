"""The text screen: cells of characters, the BIOS that writes them, and conio's window on it."""
