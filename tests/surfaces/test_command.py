"""`python -m surfaces`: files of every kind, a window that answers keys, and errors in one line."""

import math
import os
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import bgi
from bgi.memory.imagefile import load
from surfaces import FIELDS, MODES, PROJECTIONS, RAMPS, rotation, surface
from surfaces.__main__ import main
from surfaces.animation import PillowMissing, progress, save_gif
from surfaces.command.output import MILLISECONDS
from surfaces.command.parser import FILES
from surfaces.explorer import EXAMPLES
from surfaces.explorer.keys import HELP
from surfaces.explorer.loop import SMALLEST
from surfaces.formulas import formula

ROOT = Path(__file__).parents[2]


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str]:
    """The command's exit code and what it says."""
    try:
        code = main(arguments)
    except SystemExit as exit:
        assert isinstance(exit.code, int)
        code = exit.code
    out, err = capsys.readouterr()
    assert out == ""
    return code, err


def test_a_png_is_the_picture_of_the_library(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "a.PNG"
    assert run(capsys, "x*y", "--x", "-1", "2", "--turn", "30", "-n", "40", "-o", str(file)) == (
        0,
        "",
    )
    bgi.initgraph(bgi.IBM8514, bgi.IBM8514LO)
    bgi.setcolor(bgi.YELLOW)
    turn = rotation("z", math.radians(30))
    surface(formula("x*y"), (-1, 2), (-3, 3), 40, transform=turn, title="z = x*y")
    bgi.writeimagefile(tmp_path / "b.png")
    assert file.read_bytes() == (tmp_path / "b.png").read_bytes()


OPTIONS = (
    "--x -2*pi 2*pi",
    "--y 0 e",
    "--z -1 1",
    "--log z",
    "-n 20",
    "--view isometric",
    "--projection isometric",
    "--turn -90",
    "--tilt 20",
    "--theta 30",
    "--rho-z 0.5",
    *(f"--mode {mode}" for mode in ("mesh", "fill+mesh", "waterfall", "wire", "facets")),
    "--color light",
    "--ramp grey",
    "--dither",
    "--contours 5",
    "--floor 5",
    "--box",
    "--axes",
    "--colorbar",
    "--title Parabola",
)


@pytest.mark.parametrize("options", OPTIONS)
def test_every_option_changes_the_picture(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], options: str
) -> None:
    plain, changed = tmp_path / "plain.png", tmp_path / "changed.png"
    assert run(capsys, "x+y*y", "-n", "30", "-o", str(plain)) == (0, "")
    assert run(capsys, "x+y*y", "-n", "30", "-o", str(changed), *options.split()) == (0, "")
    assert bytes(pixels(plain)) != bytes(pixels(changed))


def pixels(file: Path) -> np.ndarray:
    """The colors of a picture that was written, (height, width, 3)."""
    return load(file).rgba[..., :3]


def test_every_option_is_tried(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--help"])
    shown = set(re.findall(r"^  (--?[a-z-]+)", capsys.readouterr().out, re.MULTILINE))
    tried = {option.split()[0] for option in OPTIONS}
    assert shown - tried == {"-h", "-o", "--size", "--frames", "--monitor"}
    assert tried - shown == {"--projection"}  # the old name of --view


def test_the_documentation_has_every_option_and_every_key(
    capsys: pytest.CaptureFixture[str],
) -> None:
    page = (ROOT / "docs" / "surfaces.md").read_text("utf-8")
    with pytest.raises(SystemExit):
        main(["--help"])
    shown = re.findall(r"^  (--?[a-z-]+)", capsys.readouterr().out, re.MULTILINE)
    listed = re.findall(r"`(--?[a-z-]+)[^`]*`", page[page.index("| option |") :])
    assert set(listed) == set(shown) - {"-h"}
    for names in (PROJECTIONS, MODES, FIELDS, RAMPS):
        assert ", ".join(f"`{name}`" for name in names) in page
    for keys, meaning in HELP:
        assert f"| `{keys}` | {meaning} |" in page


@pytest.mark.parametrize("size", [(320, 200), (640, 480), (800, 300), (1024, 768)])
def test_the_picture_is_as_large_as_it_should_be(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], size: tuple[int, int]
) -> None:
    file = tmp_path / "a.png"
    width, height = map(str, size)
    assert run(capsys, "x*y", "--size", width, height, "-o", str(file)) == (0, "")
    assert pixels(file).shape == (size[1], size[0], 3)


def test_a_formula_may_begin_with_a_minus(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for place, text in enumerate(("-x*y", "-1", "-hypot(x, y)", "-n(")):
        code, said = run(capsys, text, "-o", str(tmp_path / f"{place}.png"))
        assert (code, said == "") == ((0, True) if place < 3 else (2, False))


def test_svg_and_text(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for mode in ("fill", "mesh"):
        svg = tmp_path / f"{mode}.svg"
        assert run(capsys, "x < y", "--mode", mode, "-n", "9", "-o", str(svg)) == (0, "")
        texts = [node.text for node in ElementTree.parse(svg).getroot().iter() if node.text]
        assert "z = x < y" in texts
    text = tmp_path / "a.txt"
    assert run(capsys, "x*x", "-o", str(text)) == (0, "")
    lines = text.read_text("utf-8").splitlines()
    assert (lines[1].strip(), len(lines)) == ("z = x*x", 40)


def test_the_size_of_svg_and_text(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    svg, text = tmp_path / "a.svg", tmp_path / "a.txt"
    assert run(capsys, "x", "--size", "300", "200", "-n", "9", "-o", str(svg)) == (0, "")
    assert ElementTree.parse(svg).getroot().get("viewBox") == "-0.5 -0.5 300 200"
    assert run(capsys, "x", "--size", "50", "20", "-o", str(text)) == (0, "")
    lines = text.read_text("utf-8").splitlines()
    assert len(lines) == 20
    assert max(map(len, lines)) <= 50


def test_without_a_formula_there_is_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = tmp_path / "a.txt"
    assert run(capsys, "-o", str(text)) == (0, "")
    assert text.read_text("utf-8").splitlines()[1].strip() == f"z = {EXAMPLES[0]}"


def test_a_square_is_square_in_a_window_of_any_shape(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """From above, the plane from -1 to 1 by -1 to 1."""
    file = tmp_path / "a.png"
    command = "0 --x -1 1 --y -1 1 --view top --title . --size 800 300 -o"
    assert run(capsys, *command.split(), str(file)) == (0, "")
    shown = np.any(pixels(file)[20:], axis=2)  # below the title
    width, height = (np.flatnonzero(shown.any(axis=axis)).size for axis in (0, 1))
    assert abs(width - height) <= 1


def colors(file: Path) -> np.ndarray:
    """The different colors of a picture."""
    return np.unique(pixels(file).reshape(-1, 3), axis=0)


def test_dithering_takes_sixteen_colors(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "a.png"
    assert run(capsys, "x*y", "--dither", "-o", str(file)) == (0, "")
    assert 6 < len(colors(file)) <= 16
    assert np.isin(colors(file), (0, 85, 170, 255)).all()


@pytest.mark.parametrize("size", ["640 480", "1024 768", "500 400"])
def test_else_colors_are_smooth_in_every_size(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], size: str
) -> None:
    file = tmp_path / "a.png"
    assert run(capsys, "x*y", "--size", *size.split(), "-o", str(file)) == (0, "")
    assert len(colors(file)) > 100


def test_a_gif_is_a_full_turn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    image = pytest.importorskip("PIL.Image", reason="needs Pillow")
    file = tmp_path / "a.gif"
    code, said = run(capsys, "x*y", "-n", "10", "--frames", "4", "-o", str(file))
    assert code == 0
    bars = said.strip("\r\n").split("\r")
    assert [bar.split()[-1] for bar in bars] == ["1/4", "2/4", "3/4", "4/4"]
    assert [bar.count("#") for bar in bars] == [10, 20, 30, 40]
    with image.open(file) as gif:
        assert (gif.n_frames, gif.info["duration"], gif.info["loop"]) == (4, MILLISECONDS, 0)
        pictures = []
        for number in range(4):
            gif.seek(number)
            pictures.append(np.asarray(gif.convert("RGB")))
    # x*y upside down is x*y turned by a quarter: half a turn brings back the same picture.
    assert (pictures[0] != pictures[1]).any()
    shown = [picture.any(axis=2) for picture in pictures]
    assert np.count_nonzero(shown[0] != shown[2]) < 1000


def test_a_gif_without_pillow_says_what_to_type(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    file = tmp_path / "a.gif"
    code, said = run(capsys, "x*y", "-o", str(file))
    assert (code, said) == (1, 'surfaces: a GIF needs Pillow; type: pip install ".[record]"\n')
    assert not file.exists()
    with pytest.raises(PillowMissing):
        save_gif(file, iter([]), 10)


def test_progress_hands_on_every_step(capsys: pytest.CaptureFixture[str]) -> None:
    assert list(progress("abc", "counting")) == ["a", "b", "c"]
    assert capsys.readouterr().err.endswith(f"\rcounting [{'#' * 40}] 3/3\n")


@pytest.mark.parametrize("text", ["sin(x*yy)", "", "__import__('os')", "x" * 600])
def test_no_formula(tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str) -> None:
    code, said = run(capsys, text, "-o", str(tmp_path / "a.png"))
    assert code == 2
    assert said.startswith("surfaces: ")
    assert said.splitlines()[-1].strip(" ") == "^" * said.count("^")
    assert not (tmp_path / "a.png").exists()


def test_the_caret_points_at_the_word(capsys: pytest.CaptureFixture[str]) -> None:
    _, said = run(capsys, "sin(x*yy)")
    assert said == (
        "surfaces: unknown name 'yy': there are x, y, r, theta, pi, e (column 7)\n"
        "sin(x*yy)\n"
        "      ^^\n"
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("log(-1-r) -o a.png", "no finite value"),
        ("x --x 3 1 -o a.png", "x must be (a, b) with finite a < b"),
        ("x --z 1 1 -o a.png", "z must be (a, b)"),
        ("x --x 1 -o a.png", "expected 2 arguments"),
        ("x --x 0 x -o a.png", "x is no number"),
        ("x --x 0 1/0 -o a.png", "1/0 is no number"),
        ("x --x 0 foo -o a.png", "unknown name 'foo'"),
        ("x --log w -o a.png", "--log must be made of x, y and z"),
        ("x --theta 90 -o a.png", "90 is no number from 1 to 89"),
        ("x --rho-z 2 -o a.png", "2 is no number from 0.01 to 1"),
        ("x -n 0 -o a.png", "0 is no whole number from 1 to 1000"),
        ("x -n 2.5 -o a.png", "2.5 is no whole number"),
        ("x -n 100000 -o a.png", "from 1 to 1000"),
        ("x --frames 1 -o a.gif", "from 2 to 1000"),
        ("x --mode blue -o a.png", "blue"),
        ("x --ramp blue -o a.png", "blue"),
        ("x --projection blue -o a.png", "blue"),
        ("x -o a.doc", "a.doc must be a file .png, .gif, .svg, .txt"),
        ("x -o a", "a must be a file .png"),
        ("x y -o a.png", "unrecognized arguments: y"),
        ("x --view blue -o a.png", "blue"),
        ("x --view isometric --theta 30 -o a.png", "--theta has no use here: only the paper's"),
        ("x --view cabinet --rho-z 0.5 -o a.png", "--rho-z has no use here"),
        ("x --frames 9 -o a.png", "--frames has no use here: only a .gif has several pictures"),
        ("x --frames 9", "--frames has no use here"),
        ("x --monitor none -o a.png", "--monitor has no use here: a file is written without one"),
        ("x --dither -o a.svg", "--dither has no use here: only a screen has dots to mix"),
        ("x --dither --size 800 600 -o a.png", "dithering is for the 16 colours of a VGA"),
        ("x --ramp heat -o a.txt", "--ramp has no use here: characters have no colours"),
        ("x --monitor paper", "paper"),
        ("x --size 640 -o a.png", "expected 2 arguments"),
        ("x --size 0 480 -o a.png", "0 is no whole number from 1 to 4096"),
        ("x --size 640 5000 -o a.png", "5000 is no whole number from 1 to 4096"),
        ("x --size 8 8 -o a.png", "a screen of 8 x 8 pixels has no room for the picture"),
        ("x --size 320 200", "a window to explore in must be at least 480 x 240 pixels"),
        ("x --floor 51 -o a.png", "51 is no whole number from 0 to 50"),
        ("x --tilt steep -o a.png", "unknown name 'steep'"),
        ("x --x 3 1", "x must be (a, b) with finite a < b"),
        ("log(-1-r)", "no finite value"),
    ],
)
def test_wrong_use_is_one_clear_line(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: str,
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    code, said = run(capsys, *arguments.split())
    assert code == 2
    assert message in said.splitlines()[-1]
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "arguments",
    ["1e308*x", "exp(700)*sin(x)", "1e-320*x", "x --x 0 1e-320", "x --x -1e308 1e308", "1e300"],
)
def test_numbers_beyond_all_bounds(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: str
) -> None:
    code, said = run(capsys, *arguments.split(), "--axes", "-o", str(tmp_path / "a.png"))
    assert (code, said.count("\n")) in ((0, 0), (2, 1))


@pytest.mark.parametrize("ending", ["png", "gif", "svg", "txt"])
def test_a_file_that_cannot_be_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], ending: str
) -> None:
    if ending == "gif":
        pytest.importorskip("PIL", reason="needs Pillow")
    file = tmp_path / "nowhere" / f"a.{ending}"
    frames = ("--frames", "2") if ending == "gif" else ()
    code, said = run(capsys, "x", "-n", "5", *frames, "-o", str(file))
    assert code == 1
    assert re.fullmatch(r"surfaces: .*nowhere.*\n", said)


def window(monkeypatch: pytest.MonkeyPatch, file: Path, keys: str, *arguments: str) -> np.ndarray:
    """What a window shows after those keys and before Esc."""
    monkeypatch.setenv("BGI_SHOT", str(file))
    monkeypatch.setenv("BGI_KEYS", f"{keys} Esc")
    assert main(arguments) == 0
    return pixels(file)


def test_the_window_is_the_explorer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What keys do there is tested in test_explorer.py."""
    plain, turned, unknown, back, given = (
        window(monkeypatch, tmp_path / "a.png", *keys)
        for keys in (
            ("", "x"),
            ("Right Right Up", "x"),
            ("j F5 Del ~", "x"),
            ("Right Left", "x"),
            ("", "x", "--turn", "10", "--tilt", "5"),
        )
    )
    assert (plain != turned).any()
    assert (plain == unknown).all()
    assert (plain == back).all()
    assert (turned == given).all()


@pytest.mark.parametrize("option", [option for option in OPTIONS if "dither" not in option])
def test_every_option_changes_the_window(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, option: str
) -> None:
    plain = window(monkeypatch, tmp_path / "a.png", "", "x+y*y")
    changed = window(monkeypatch, tmp_path / "a.png", "", "x+y*y", *option.split())
    assert (plain[:400] != changed[:400]).any()


def test_the_size_of_the_window(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for size in (SMALLEST, (640, 480), (900, 500)):
        shown = window(monkeypatch, tmp_path / "a.png", "", "x", "--size", *map(str, size))
        assert shown.shape == (size[1], size[0], 3)


def test_a_monitor_may_be_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("BGI_MONITOR")
    monkeypatch.setenv("BGI_KEYS", "Esc")
    assert main(["x", "--monitor", "none"]) == 0


@pytest.mark.parametrize(
    ("error", "code"), [(bgi.WindowClosed("closed"), 0), (KeyboardInterrupt(), 130)]
)
def test_ends_quietly_when_the_user_ends_it(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    error: BaseException,
    code: int,
) -> None:
    def interrupted() -> int:
        raise error

    monkeypatch.setattr("surfaces.explorer.keys.getch", interrupted)
    assert run(capsys, "x") == (code, "")


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="there is always a display")
def test_without_a_display_it_says_so_in_one_line() -> None:
    hidden = {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "BGI_MONITOR"}
    ran = subprocess.run(
        [sys.executable, "-m", "surfaces", "x*y"],
        cwd=ROOT,
        env={name: value for name, value in os.environ.items() if name not in hidden},
        capture_output=True,
        text=True,
    )
    assert (ran.returncode, ran.stdout) == (1, "")
    assert re.fullmatch("surfaces: no display .* -o picture.png\n", ran.stderr)


def test_help_names_everything(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as exit:
        main(["--help"])
    assert exit.value.code == 0
    text = capsys.readouterr().out
    for word in (
        "--rho-z",
        "atan2",
        "theta",
        "waterfall",
        "isometric",
        "heat",
        "-o turning.gif",
        *FILES,
    ):
        assert word in text
