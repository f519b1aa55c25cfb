"""Turbo C and C++ programs as they are: read, understood, and run on this library.

A source goes through stages, each a function of the one before: its text (`source`), words without
directives (`preprocess`, `lexer`), a tree (`nodes`), types, Python.
"""
