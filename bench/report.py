"""Tables: the rows in which we are behind come first."""

from collections.abc import Iterable
from math import inf, log

from bench.groups.plots import GROWN, LARGE, SIZES
from bench.saved import Run
from bench.timing import Result

PEERS = ("SDL_bgi", "pygame", "matplotlib", "gnuplot", "PLplot", "Python")
HEAD = (
    "A unit is an empty call of three arguments in a loop inside a function. Ratios are the\n"
    "peer's time through ours, in the same round: above 1, we are faster. Rows where we are\n"
    "behind come first: behind SDL_bgi, or where it has nothing like it, behind the fastest peer."
)


def standing(result: Result) -> float:
    """The ratio that says whether we are behind: pygame is only asked where no other has the row.

    pygame draws without Borland's styles, viewport and rules; SDL_bgi has them.
    """
    like = [ratio for peer, ratio in result.ratios.items() if peer in PEERS and peer != "pygame"]
    return min(like, default=result.ratios.get("pygame", inf))


def in_order(results: Iterable[Result]) -> list[Result]:
    """The worst first."""
    return sorted(results, key=standing)


def amount(result: Result) -> str:
    """What was measured of us, in words."""
    value = result.seconds
    if result.group == "memory":
        return f"{value:.0f} MiB"
    return f"{value * 1e6:.2f} us" if value < 1e-3 else f"{value * 1e3:.1f} ms"


def growth(result: Result) -> float:
    """The exponent with which the time grows with the number of cells: 1 is linear."""
    return -log(result.ratios[GROWN]) / log((LARGE / SIZES[-1]) ** 2)


def units(result: Result) -> str:
    """The same in units; of growth its exponent."""
    if result.group == "growth":
        return f"^{growth(result):.2f}"
    return "" if result.group == "memory" else f"{result.units:.1f}"


def table(run: Run) -> str:
    """All rows of a run."""
    lines = [HEAD, f"The unit: {run.unit * 1e9:.0f} ns. Rounds: {run.rounds}, medians."]
    lines += [", ".join(f"{name} {number}" for name, number in run.versions.items())]
    lines += [f"{peer}: not installed" for peer in run.missing]
    peers = [peer for peer in PEERS if any(peer in result.ratios for result in run.results)]
    lines += ["", f"{'':36}{'ours':>12}{'units':>12}" + "".join(f"{p:>11}" for p in peers)]
    for result in in_order(run.results):
        ratios = (result.ratios.get(peer) for peer in peers)
        shown = "".join(f"{'' if ratio is None else f'{ratio:.2f}':>11}" for ratio in ratios)
        lines.append(f"{result.name:36}{amount(result):>12}{units(result):>12}{shown}".rstrip())
    return "\n".join(lines)


def comparison(then: Run, now: Run) -> str:
    """The rows that both runs have: how many times as fast they became, the slower ones first."""
    before = {result.name: result for result in then.results}
    pairs = [(before[r.name], r) for r in now.results if r.name in before and r.units]
    faster = sorted((measured(a) / measured(b), a, b) for a, b in pairs)
    lines = [f"{'':36}{'then':>12}{'now':>12}{'faster':>11}"]
    for times, a, b in faster:
        lines.append(f"{b.name:36}{measured(a):12.1f}{measured(b):12.1f}{times:11.2f}")
    return "\n".join(lines)


def measured(result: Result) -> float:
    """What is compared: units, or of memory MiB."""
    return result.seconds if result.group == "memory" else result.units
