"""A program's side of the web monitor, for pages to look at."""

from collections.abc import Iterator

import pytest

from bgi.memory.card import Card
from bgi.monitor import PageWindow
from bgi.monitor.web import pagewindow
from tests.processes import gone, shared_memory


@pytest.fixture(autouse=True)
def _alone(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """No settings of elsewhere, none that outlive a test, and nothing left behind."""
    before = shared_memory()
    for name in ("PORT", "TOKEN", "HOSTS", "ADDRESS", "OPEN"):
        monkeypatch.setenv(f"BGI_WEB_{name}", "")  # so that it is as before at the end
        monkeypatch.delenv(f"BGI_WEB_{name}")
    yield
    assert shared_memory() <= before


@pytest.fixture
def card() -> Card:
    card = Card()
    card.set_mode(640, 480, 2)
    return card


@pytest.fixture
def window(card: Card, monkeypatch: pytest.MonkeyPatch) -> Iterator[PageWindow]:
    """A screen that waits for no page."""
    monkeypatch.setattr(pagewindow, "PAGE_SECONDS", 0)
    window = PageWindow(card, "a test ✓")
    yield window
    window.close()
    assert gone(window.pid)
