"""The PC's software interrupts: a module for each, with a table of its functions."""
