"""Programs that are damaged, or none at all: an error that says where, or a run, nothing else."""

import re
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from bgi import current
from bgi.errors import BGIError
from bgi.turboc.faults import CError, CErrors
from bgi.turboc.running import Runnable
from bgi.turboc.runtime.session import Session

HERE = Path(__file__)
PROGRAMS = [
    *sorted(HERE.with_name("library").glob("*.C*")),
    *sorted((HERE.parents[2] / "demos" / "c").glob("*.C*")),
]
WORD = re.compile(rb'[A-Za-z_]\w*|\d[\w.]*|"(?:\\.|[^"\\\n])*"|\s+|.', re.DOTALL)
TEXTS = [program.read_bytes() for program in PROGRAMS]
WORDS = [WORD.findall(text) for text in TEXTS]
OTHERS = [b"0", b"-1", b"32767", b"65536", b"0.5", b"*", b"/", b"%", b"&", b"<<", b"(", b"}", b"'"]


@st.composite
def exchanged(draw):
    """A program of which a few words are others, doubled or lost."""
    words = list(draw(st.sampled_from(WORDS)))
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(words) - 1))
        instead = [draw(st.sampled_from(OTHERS)), draw(st.sampled_from(words)), words[at] * 2, b""]
        words[at] = draw(st.sampled_from(instead))
    return b"".join(words)


@st.composite
def cut_off(draw):
    """A program that ends too early."""
    text = draw(st.sampled_from(TEXTS))
    return text[: draw(st.integers(0, len(text)))]


def survives(path: Path, text: bytes) -> bool:
    """Read a program, and run it if it can be run; returns whether it could."""
    path.write_bytes(text)
    try:
        Runnable(str(path), {}).run(Session(path.with_name("trace"), "A"))
    except CErrors as found:
        assert 0 < len(found.errors) <= 20
        assert all(one.place.line or one.message for one in found.errors)
        return False
    except CError as fault:
        assert "this cannot be done here" not in fault.message, fault.__cause__
    except BGIError:
        pass
    finally:
        current.close_screen()
    return True


@pytest.fixture(scope="module", params=["C", "CPP"])
def path(request, tmp_path_factory):
    return tmp_path_factory.mktemp("c") / f"T.{request.param}"


@pytest.fixture(autouse=True)
def _soon_over(monkeypatch):
    """A program that loops for ever is not waited for."""
    monkeypatch.setattr("bgi.turboc.runtime.session.SECONDS", 0.5)
    monkeypatch.setattr("bgi.turboc.runtime.timelimit.LOOK_SECONDS", 0.2)
    monkeypatch.setattr("bgi.turboc.runtime.trace.MOST_LINES", 500)


SHARED = [HealthCheck.function_scoped_fixture, HealthCheck.differing_executors]
DAMAGED = settings(max_examples=25, deadline=None, suppress_health_check=SHARED)


@DAMAGED
@given(text=exchanged())
def test_a_program_with_other_words(path, text):
    survives(path, text)


@DAMAGED
@given(text=cut_off())
def test_a_program_that_ends_too_early(path, text):
    survives(path, text)


@DAMAGED
@given(text=st.binary(max_size=300))
def test_what_is_no_program(path, text):
    survives(path, text)


REPEATED = ["(", ")", "{", "}", "(int)", "*", "x(", "\"'", "#if 1\n", "a,", "1+", "/*", "case 1:"]


@pytest.mark.parametrize("head", ["", "int main() { int x = "])
@pytest.mark.parametrize("text", REPEATED)
def test_a_megabyte_of_the_same(tmp_path, head, text):
    whole = head + text * (1_000_000 // len(text))
    assert not survives(tmp_path / "T.CPP", whole.encode())
