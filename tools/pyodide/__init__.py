"""Python for the browser: where its parts come from, and our tests in it."""
