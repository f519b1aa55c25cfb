"""The course's own solutions get full marks from the grader, with what they check themselves."""

import re
import shutil

import pytest

from bgi.lab.grading import Limits, grade
from bgi.lab.tasks import Task
from tools import pictures

CHECK = re.compile(r"^(?:assert )?check\.(?!picture)(\w+)\((\w+)(?:, (\w+)=True)?\)", re.MULTILINE)
SOLUTIONS = {
    program: CHECK.findall(program.read_text("utf-8"))
    for program in sorted((pictures.COURSE / "solutions").glob("*.py"))
}
GRADED = [program for program, checks in SOLUTIONS.items() if checks]


def test_eight_lessons_have_functions_to_check():
    assert sum(map(len, SOLUTIONS.values())) >= 18
    numbers = [program.stem[:2] for program in GRADED]
    assert numbers == ["02", "03", "04", "05", "06", "07", "08", "12"]


@pytest.mark.parametrize("program", GRADED, ids=[program.stem for program in GRADED])
def test_a_solution_gets_full_marks(program, tmp_path):
    shutil.copyfile(program, tmp_path / program.name)
    tasks = [
        Task(exercise, function, 2, {option: True} if option else {}, function)
        for exercise, function, option in SOLUTIONS[program]
    ]
    (graded,) = grade(tmp_path, tasks, Limits(60))
    assert [mark.reason for mark in graded.marks if not mark.right] == []
    assert graded.points == graded.of == 2 * len(tasks)
