"""Axes that are logarithmic, or have dates: the same pictures with other numbers."""

import re
from datetime import date, datetime, timedelta, timezone
from typing import Any

import numpy as np
import pytest

from surfaces import Plot, Svg, data, parametric, perspective, sample, sheet, surface
from tests.surfaces.raycast import Canvas

MODES = ["fill", "mesh", "fill+mesh", "waterfall", "wire", "facets"]
X, Y = np.geomspace(1, 1000, 16), np.linspace(-1, 1, 12)
Z = np.exp(np.add.outer(np.sin(np.log(X)), Y))
GRID = np.meshgrid(X, Y, indexing="ij")
TURN = np.linspace(0, 6, 30)
POINTS = np.stack((np.exp(TURN), np.cos(TURN), np.exp(np.sin(TURN))), axis=1)


def pictured(draw: Any, *shape: Any, **how: Any) -> Any:
    canvas = Canvas(120, 90)
    draw(*shape, **{"on": canvas, "lines": 14} | how)
    return canvas.array


def logs(points: Any, which: str) -> Any:
    """The logarithms of some of the coordinates."""
    return [
        np.log10(part) if name in which else part for part, name in zip(points, "xyz", strict=True)
    ]


# Logarithms ------------------------------------------------------------------------------------


@pytest.mark.parametrize("log", ["x", "z", "xz"])
@pytest.mark.parametrize("mode", MODES)
def test_the_log_of_data_is_the_data_of_logs(mode: str, log: str) -> None:
    x, y, z = logs((X, Y, Z), log)
    levels = [np.array((0.5, 2.0))] * 2
    levels = [np.log10(levels[0]) if "z" in log else levels[0], levels[1]]
    expected = pictured(surface, z, x, y, mode=mode, contours=levels[0], box=True)
    assert expected.any()
    got = pictured(surface, Z, X, Y, mode=mode, log=log, contours=levels[1], box=True)
    assert (got == expected).all()


def test_the_same_for_functions_grids_sheets_and_bodies() -> None:
    def f(x: Any, y: Any) -> Any:
        return x**2 / (1.5 + y)

    def of_logs(x: Any, y: Any) -> Any:
        return np.log10(f(10.0**x, y))

    expected = pictured(surface, of_logs, (0, 2), (-1, 1), 30, z=(-2, 3))
    got = pictured(surface, f, (1, 100), (-1, 1), 30, z=(0.01, 1000), log="xz")
    assert (got == expected).all()

    grid = sample(f, (1, 100), (-1, 1), 30)
    nodes = data(np.log10(grid.z), np.log10(grid.x), grid.y)
    assert (pictured(surface, grid, log="xz") == pictured(surface, nodes)).all()

    bent = (GRID[0], GRID[1] * GRID[0] ** 0.1, Z)
    for_sheet = pictured(sheet, *logs(bent, "xz"), axes=False, zfrac=0.3)
    assert (pictured(sheet, *bent, log="xz", zfrac=0.3) == for_sheet).all()

    def body(u: Any, v: Any) -> Any:
        return 10**u, v, 10 ** (u * v)

    def body_of_logs(u: Any, v: Any) -> Any:
        return u, v, u * v

    of_body = pictured(parametric, body_of_logs, (0, 1), (0, 1), 20)
    got = pictured(parametric, body, (0, 1), (0, 1), 20, log="xz")
    assert (got != of_body).mean() < 0.01  # where 10 to a power rounds otherwise


@pytest.mark.parametrize("color", ["slope", "light", Z, lambda x, y: x * y])
def test_colors_of_logarithmic_surfaces(color: Any) -> None:
    of_logs = (lambda x, y: color(10.0**x, y)) if callable(color) else color
    expected = pictured(surface, Z, np.log10(X), Y, color=of_logs)
    got = pictured(surface, Z, X, Y, color=color, log="x")
    assert np.abs(got - expected).max() <= 1  # of the number that 10.0**x gives again


def test_what_is_added_to_a_scene_is_laid_out_like_it() -> None:
    canvases = [Canvas(120, 90), Canvas(120, 90)]
    x, _, z = logs((X, Y, Z), "xz")
    plots = [
        surface(z, x, Y, on=canvases[0]),
        surface(Z, X, Y, log="xz", on=canvases[1]),
    ]
    of_logs = np.stack(logs(POINTS.T, "xz"), axis=1)
    for plot, points in zip(plots, (of_logs, POINTS), strict=True):
        plot.curve(points, 12)
        plot.points(points[::3], 13)
    assert (canvases[0].array == canvases[1].array).all()
    assert plots[1].project(POINTS) == pytest.approx(plots[0].project(of_logs))
    assert plots[1].depth(POINTS) == pytest.approx(plots[0].depth(of_logs))
    bent = (GRID[0], GRID[1] / 2, 1.5 * Z)
    plots[0].sheet(*logs(bent, "xz"))
    plots[1].sheet(*bent)
    assert (canvases[0].array == canvases[1].array).all()


@pytest.mark.parametrize("view", [{}, {"projection": perspective(3)}])
def test_what_is_read_off_are_the_numbers_themselves(view: Any) -> None:
    plot = surface(lambda x, y: x**2 * y, (1, 100), (0.1, 1), 60, log="xyz", on=Canvas(120, 90))
    px, py, _ = plot.project((10, 0.5, 50))
    picked = plot.pick(px, py)
    assert picked == pytest.approx((10, 0.5, 50), rel=1e-6)
    assert plot.unproject(plot.project(POINTS[:, [0, 2, 2]])) == pytest.approx(POINTS[:, [0, 2, 2]])


def test_what_is_not_above_0_has_no_place_there() -> None:
    z = np.array([[1.0, 10, 100], [1, -5, 0], [1, 10, 100]])
    holes = np.where(z > 0, z, np.nan)
    assert (pictured(surface, z, log="z") == pictured(surface, np.log10(holes))).all()
    x = GRID[0] - 2
    with_hole = np.where(x > 0, x, np.nan)
    expected = pictured(sheet, np.log10(with_hole), GRID[1], Z, zfrac=0.3)
    assert (pictured(sheet, x, GRID[1], Z, zfrac=0.3, log="x") == expected).all()
    canvas = Canvas(120, 90)
    plot = surface(Z, X, Y, log="x", on=canvas)
    before = canvas.array.copy()
    plot.points([(0, 0, 1), (-3, 0, 1)])
    plot.curve([(1, 0, 1), (-1, 0, 1), (10, 0, 1)])
    assert (canvas.array == before).all()


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"x": (0, 15), "log": "x"}, "x must be above 0 on a logarithmic axis"),
        ({"log": "x"}, "x must be above 0 on a logarithmic axis"),
        ({"x": X - 1, "log": "x"}, "x must be above 0 on a logarithmic axis"),
        ({"z": (-1, 5), "log": "z"}, r"z must be above 0 on a logarithmic axis, not \(-1, 5\)"),
        ({"contours": [1, 0], "log": "z"}, "contours must be above 0 on a logarithmic axis"),
        ({"floor": [-2], "log": "z"}, "floor must be above 0 on a logarithmic axis"),
        ({"f": -Z, "log": "z"}, "f must have a value above 0, where z is logarithmic"),
        ({"f": lambda x, y: -x, "x": (1, 2), "y": (1, 2), "log": "z"}, "or none above 0"),
        ({"f": lambda x, y: x, "x": (-1, 2), "y": (1, 2), "log": "x"}, r"x must be .*-1, 2"),
    ],
)
def test_limits_and_levels_must_have_a_place(how: Any, message: str) -> None:
    canvas = Canvas(160, 120)
    with pytest.raises(ValueError, match=message):
        surface(**{"f": Z, "on": canvas, "axes": True} | how)
    assert not canvas.array.any()


def test_far_from_zero_a_logarithm_is_as_fine_as_the_numbers() -> None:
    def f(x: Any, y: Any) -> Any:
        return np.sin(x - 1e6) * y

    plain = pictured(surface, f, (1e6, 1e6 + 6), (0, 1), 60)
    got = pictured(surface, f, (1e6, 1e6 + 6), (0, 1), 60, log="x")
    assert (got != plain).mean() < 0.01


def texts(drawing: Svg) -> list[str]:
    return re.findall(r"<text[^>]*>([^<]*)</text>", str(drawing))


def test_powers_of_ten_are_written_and_marked_between() -> None:
    drawings = []
    for log in ("", "xz"):
        drawing = Svg(640, 480)
        surface(Z, X, Y, log=log, axes=True, colorbar=True, on=drawing)
        drawings.append(drawing)
    assert {"1", "10", "100", "1000"} <= set(texts(drawings[1]))
    plain, logarithmic = (str(drawing).count("<path") for drawing in drawings)
    assert logarithmic > plain + 20  # 24 steps of x, and those of z


def test_small_ticks_need_room() -> None:
    def count(size: int) -> int:
        drawing = Svg(size, size)
        surface([[1, 10], [10, 100]], x=(1, 1000), log="x", axes=True, on=drawing)
        return str(drawing).count("<path")

    assert count(400) - count(120) > 20


# Dates -------------------------------------------------------------------------------------------

DAYS = np.arange("2026-11-20", "2026-12-02", dtype="datetime64[D]")
HOURS = np.arange(5.0)
HEIGHTS = np.sin(np.add.outer(np.arange(12.0), HOURS))
UTC_PLUS_2 = timezone(timedelta(hours=2))
KINDS: dict[str, Any] = {
    "days": DAYS,
    "nanoseconds": DAYS.astype("datetime64[ns]"),
    "seconds": DAYS.astype("datetime64[s]"),
    "dates": [date(2026, 11, 20) + timedelta(days=n) for n in range(12)],
    "times": [datetime(2026, 11, 20) + timedelta(days=n) for n in range(12)],
    "zones": [datetime(2026, 11, 20, 2, tzinfo=UTC_PLUS_2) + timedelta(days=n) for n in range(12)],
    "numpy's": list(DAYS),
    "ends": (date(2026, 11, 20), np.datetime64("2026-12-01")),
}


def dated(on: Any, x: Any = DAYS, **how: Any) -> Plot:
    return surface(HEIGHTS, x, HOURS, on=on, **how)


@pytest.mark.parametrize("kind", KINDS)
def test_dates_of_any_kind_are_days(kind: str) -> None:
    expected = pictured(surface, HEIGHTS, 86400.0 * np.arange(12), HOURS)
    canvas, drawing = Canvas(120, 90), Svg(640, 480)
    dated(canvas, KINDS[kind], lines=14)
    assert (canvas.array == expected).all()
    dated(drawing, KINDS[kind], axes=("day", "hour", "C"))
    assert {"Nov 21", "Nov 25", "Dec 1", "day (2026)"} <= set(texts(drawing))


def test_dates_may_fall_and_may_be_those_of_meshgrid() -> None:
    expected = Canvas(120, 90)
    dated(expected)
    falling, grids = Canvas(120, 90), Canvas(120, 90)
    surface(HEIGHTS[::-1], DAYS[::-1], HOURS, on=falling)
    surface(HEIGHTS, *np.meshgrid(DAYS, HOURS, indexing="ij"), on=grids)
    assert (falling.array == expected.array).all()
    colored, turned = Canvas(120, 90), Canvas(120, 90)
    dated(colored, color=HEIGHTS**2)
    surface(HEIGHTS[::-1], DAYS[::-1], HOURS, color=HEIGHTS[::-1] ** 2, on=turned)
    assert (turned.array == colored.array).all()
    assert (grids.array == expected.array).all()


def test_on_y_and_on_both() -> None:
    drawing = Svg(640, 480)
    hours = np.datetime64("2026-11-25T08", "h") + np.arange(5)
    surface(HEIGHTS, DAYS, hours, axes=True, on=drawing)
    assert {"x (2026)", "y (2026-11-25)", "Nov 21", "Dec 1", "08:00", "10:00"} <= set(
        texts(drawing)
    )


def test_there_is_room_for_times_beside_a_bar_of_colors() -> None:
    drawing = Svg(640, 480)
    seconds = np.datetime64("2026-11-25T08:10:00") + np.arange(5)
    surface(HEIGHTS, y=seconds, projection="top", axes=True, colorbar=True, on=drawing)
    assert {f"08:10:0{second}" for second in range(5)} <= set(texts(drawing))


def test_places_beyond_the_calendar_are_no_dates() -> None:
    plot = dated(Canvas(120, 90))
    far = plot.unproject([(1e30, 1e30, 1e30), (60, 45, 0)])
    assert np.isnat(far[0, 0])
    assert not np.isnat(far[1, 0])


def test_functions_are_asked_for_dates() -> None:
    asked: list[Any] = []

    def f(when: Any, y: Any) -> Any:
        asked.append(when)
        return (when - DAYS[0]) / np.timedelta64(1, "D") * y

    canvas, expected = Canvas(120, 90), Canvas(120, 90)
    surface(f, (DAYS[0], DAYS[-1]), (0, 1), 20, color=lambda when, y: f(when, y + 1), on=canvas)
    surface(lambda x, y: x * y, (0, 11), (0, 1), 20, color=lambda x, y: x * (y + 1), on=expected)
    assert (canvas.array == expected.array).all()
    assert asked[0][0, 0] == DAYS[0]
    assert asked[0][-1, 0] == DAYS[-1]


def test_sheets_and_bodies_have_dates() -> None:
    when, hour = np.meshgrid(DAYS, HOURS, indexing="ij")
    seconds = (when - DAYS[0]) / np.timedelta64(1, "s")
    expected = pictured(sheet, seconds, hour, HEIGHTS, zfrac=0.3)
    assert (pictured(sheet, when, hour, HEIGHTS, zfrac=0.3) == expected).all()
    with_hole = when.copy()
    with_hole[3, 2] = "NaT"
    hole = np.where(np.isnat(with_hole), np.nan, seconds)
    expected = pictured(sheet, hole, hour, HEIGHTS, zfrac=0.3)
    assert (pictured(sheet, with_hole, hour, HEIGHTS, zfrac=0.3) == expected).all()
    masked = np.ma.masked_array(when, np.isnat(with_hole))
    assert (pictured(sheet, masked, hour, HEIGHTS, zfrac=0.3) == expected).all()

    def body(u: Any, v: Any) -> Any:
        return DAYS[0] + (86400 * u).astype("timedelta64[s]"), v, u * v

    def of_seconds(u: Any, v: Any) -> Any:
        return np.floor(86400 * u), v, u * v

    expected = pictured(parametric, of_seconds, (0, 9), (0, 1), 9, zfrac=0.3)
    assert (pictured(parametric, body, (0, 9), (0, 1), 9, zfrac=0.3) == expected).all()


def test_points_and_curves_have_dates_and_reading_off_gives_them_back() -> None:
    canvas, expected = Canvas(120, 90), Canvas(120, 90)
    plot = dated(canvas)
    plain = surface(HEIGHTS, 86400.0 * np.arange(12), HOURS, on=expected)
    line = np.column_stack((np.arange(12.0), np.full(12, 2.0), np.full(12, 1.5)))
    seconds = line * (86400, 1, 1)
    for kind in ("days", "nanoseconds", "times", "zones", "numpy's"):
        points = [(day, y, z) for day, (_, y, z) in zip(KINDS[kind], line, strict=True)]
        assert plot.project(points) == pytest.approx(plain.project(seconds))
        plot.curve(points, 12)
        plain.curve(seconds, 12)
        assert (canvas.array == expected.array).all()
    px, py, _ = plot.project((datetime(2026, 11, 24, 12), 2.5, 0))
    (when, *rest), right = plot.pick(px, py) or (), plain.pick(px, py) or ()
    assert abs((when - DAYS[0]) / np.timedelta64(1, "s") - right[0]) < 1e-5
    assert rest == list(right[1:])
    found = plot.unproject(plot.project([(DAYS[3], 1.0, 0.5)]))
    assert found[0, 0] - DAYS[3] == np.timedelta64(0, "us")
    assert found[0, 1:].astype(float) == pytest.approx((1, 0.5))
    with pytest.raises(TypeError, match="x must be dates, as its axis has them"):
        plot.points([(3.0, 1.0, 1.0)])


def test_a_nanosecond_is_told_from_the_next() -> None:
    nanoseconds = np.datetime64("2026-11-25T08:00:00.123456789") + np.arange(12)
    expected = pictured(surface, HEIGHTS, np.arange(12.0), HOURS)
    canvas = Canvas(120, 90)
    dated(canvas, nanoseconds, lines=14)
    assert (canvas.array != expected).mean() < 0.01
    plot = dated(canvas, nanoseconds, projection="top")
    px, py, _ = plot.project((nanoseconds[5], 2.0, HEIGHTS[5, 2]))
    picked = plot.pick(px, py)
    assert picked
    assert abs(picked[0] - nanoseconds[5]) <= np.timedelta64(1, "ns")


@pytest.mark.parametrize(
    ("how", "error", "message"),
    [
        ({"f": np.full((12, 5), DAYS[0])}, TypeError, "f must be numbers, not dates: count them"),
        ({"color": np.full((12, 5), DAYS[0])}, TypeError, "color must be numbers, not dates"),
        ({"log": "x"}, ValueError, "log must leave out x, which has dates"),
        ({"x": DAYS[:5]}, ValueError, r"x must be \(a, b\) or 12 rising or falling numbers"),
        ({"x": np.full(12, "NaT", "datetime64[D]")}, ValueError, "x must have a date"),
        ({"x": [date(2026, 1, 1), 3.0]}, TypeError, "x must be numbers"),
        ({"x": np.array(("20000", "20012"), "datetime64[Y]")}, ValueError, "years 1 to 9999"),
        (
            {"f": lambda x, y: y, "x": (DAYS[5], DAYS[0]), "y": (0, 1)},
            ValueError,
            r"x must be \(a, b\) with dates a < b",
        ),
        (
            {"f": lambda x, y: y, "x": DAYS, "y": (0, 1)},
            ValueError,
            r"x must be \(a, b\) with dates",
        ),
    ],
)
def test_dates_that_cannot_be(how: Any, error: type[Exception], message: str) -> None:
    canvas = Canvas(160, 120)
    with pytest.raises(error, match=message):
        surface(**{"f": HEIGHTS, "x": DAYS, "y": HOURS, "on": canvas} | how)
    assert not canvas.array.any()
