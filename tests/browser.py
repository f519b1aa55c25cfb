"""What cannot pass in a browser's Python: `python -m tools.pyodide` runs the tests there.

A test that starts a process or a thread ends with an error of Python's own, which tells itself
from a mistake of ours. The others are listed here.
"""

from collections.abc import Generator

import pytest

from tests.skips import BROWSER

ERRORS = {
    "emscripten does not support processes": "there are no processes",
    "can't start new thread": "there are no threads",
}
CANNOT = {
    "there are no processes": {
        "tests/test_demos.py": [
            "TestCommand::test_goes_on_in_the_same_window",
            "TestCommand::test_runs_a_demo_from_the_menu_and_comes_back",
            "TestCommand::test_saves_every_picture",
            "TestProgramsInC::test_runs_from_the_gallery",
        ],
    },
    "there are no threads": {
        "tests/bgi/test_screen.py": [
            "test_a_mode_that_changes_leaves_calls_of_other_threads_whole"
        ],
    },
    "no array is so large": {
        "tests/bgi/test_limits.py": ["test_arrays_that_are_a_billion_together"],
    },
    "endless recursion through C ends Python": {  # its stack is JavaScript's; a page begins anew
        "tests/lab/test_checks.py": [
            "test_nothing_that_a_function_does_ends_the_check[it was stopped 20,000 calls deep]"
        ],
        "tests/turboc/test_faults.py": ["test_every_endless_recursion_ends"],
    },
    "Python is always at a prompt": {  # sys.flags.inspect is set
        "tests/turboc/test_command.py": ["test_nobody_there_is_told"],
    },
    "two mappings of a file share no memory": {
        "tests/bgi/test_card.py": [
            "test_a_monitor_survives_any_small_header",
            "test_changes_wrap",
            "test_pixels_follow_page_after_page_from_top_to_bottom",
            "test_the_header_is_as_documented",
            "test_the_header_of_a_text_mode_is_as_documented",
            "test_the_other_side_sees_the_same_memory",
            "test_where_there_is_no_memfd",
        ],
    },
    "floating point differs in the last bit": {  # and the demo shows how errors add up
        "tests/test_docs.py": ["test_the_picture_of_a_demo_is_what_it_draws[turn]"],
    },
    "argparse speaks otherwise": {
        "tests/surfaces/test_command.py": ["test_wrong_use_is_one_clear_line"],
    },
}
_REASONS = {
    f"{file}::{name}": reason
    for reason, files in CANNOT.items()
    for file, names in files.items()
    for name in names
}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Leave out, in a browser's Python, what is listed."""
    for item in items:
        name = item.nodeid
        reason = _REASONS.get(name) or _REASONS.get(name.partition("[")[0])
        if BROWSER and reason:
            item.add_marker(pytest.mark.skip(reason=reason))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call() -> Generator[None, None, None]:
    """Skip a test that has started what there is not."""
    try:
        return (yield)
    except (OSError, RuntimeError) as error:
        for words, reason in ERRORS.items():
            if BROWSER and words in str(error):
                pytest.skip(reason)
        raise
