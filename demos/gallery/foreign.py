"""What to say when another package has the name of one that the demos need."""

import sys

OURS = ("bgi", "surfaces")


def explain(error: ImportError) -> str:
    """A line about what could not be imported, and what to do about it."""
    package = (error.name or "").partition(".")[0]
    there = sys.modules.get(package)
    if there is None or package not in OURS:
        if not isinstance(error, ModuleNotFoundError):
            return str(error)  # which says what to do
        return f"{error}; in the folder of the project, type: pip install ."
    return (
        f"{there.__file__} is not the package {package} that belongs to the demos; "
        "remove it, or use a virtual environment"
    )
