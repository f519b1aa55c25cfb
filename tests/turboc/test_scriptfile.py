"""Scripts of one's own."""

import pytest

from bgi.__main__ import main
from bgi.turboc.runtime.scriptfile import scripted

SCRIPT = """# a script
keys Enter 1
keys Left
endless Esc q
typed 5 6
line Ada Byron
mouse 10 20
mouse 30 40 1
clock 2001-02-03 04:05:06
"""


@pytest.fixture
def written(tmp_path):
    """Writes a script."""

    def write(text):
        path = tmp_path / "script.txt"
        path.write_text(text)
        return str(path)

    return write


def test_a_script_is_followed(written):
    pc = scripted(written(SCRIPT))
    assert [pc.getch() for _ in range(7)] == [13, ord("1"), 0, 75, 27, ord("q"), 27]
    typed = "5\n6\nAda Byron\n"
    assert "".join(pc.getc() for _ in range(20)) == (typed + typed)[:20]
    assert [pc.mouse() for _ in range(3)] == [(0, 10, 20), (1, 30, 40), (0, 10, 20)]
    assert pc.now() == 981_173_106


def test_what_a_script_does_not_say_is_little(written):
    pc = scripted(written(""))
    assert (pc.getch(), pc.getc(), pc.mouse()) == (27, "\n", (0, 0, 0))


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("press Enter", "press is none of keys"),
        ("keys Enterr", "Enterr"),
        ("mouse 1", "mouse needs x, y"),
        ("clock noon", "noon"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(written, line, message):
    with pytest.raises(ValueError, match=rf"script\.txt:2: .*{message}"):
        scripted(written(f"\n{line}\n"))


def test_the_command_takes_a_script(written, tmp_path, capsys):
    program = tmp_path / "P.C"
    program.write_text('#include <stdio.h>\nint main() { int n; scanf("%d", &n); return n; }')
    assert main(["--script", written("typed 42"), str(program)]) == 42
    assert main(["--script", str(tmp_path / "none"), str(program)]) == 2
    assert "--script is A, B or a file" in capsys.readouterr().err
