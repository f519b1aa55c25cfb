"""The rows, a module for each group. Each has `rows()`, which makes those that can be measured."""
