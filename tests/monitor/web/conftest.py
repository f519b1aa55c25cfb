"""A program's side of the web monitor, for pages to look at."""

from collections.abc import Iterator

import pytest

from bgi.memory.card import Card
from bgi.monitor import PageWindow
from bgi.monitor.web import pagewindow
from tests.monitor.web.tabs import CANVAS
from tests.processes import gone, shared_memory
from tests.skips import IN_CI
from tools import chromium
from tools.chromium import Browser, Tab


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


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    found = chromium.program()
    if IN_CI or found is None:
        pytest.skip("needs Chromium")
    with chromium.running(found) as browser:
        yield browser


@pytest.fixture
def blank(browser: Browser) -> Iterator[Tab]:
    """An empty tab."""
    tab = browser.tab()
    tab.resize(1000, 700)
    yield tab
    tab.close()


@pytest.fixture
def tab(blank: Tab, window: PageWindow) -> Tab:
    """A tab with the page of `window`."""
    blank.go(window.url)
    blank.wait_for(f"{CANVAS}.width > 300")
    return blank
