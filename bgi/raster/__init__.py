"""Pure geometry: integers in, points or spans out. No settings, no page, no colours."""
