"""The site's pages, as they are written: links lead somewhere, and nothing comes from elsewhere."""

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from gallery.catalogue import C_NAMES, NAMES
from tools.site import build


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    build.write_pages(folder)
    return folder


class Page(HTMLParser):
    """What a page links to and loads, its places, and its programs."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.places: list[str] = []
        self.programs: list[str] = []
        self.feed(file.read_text("utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        if tag == "a":
            self.links.append(given["href"])
        if not given.get("src", "data:").startswith("data:"):  # in the page itself
            self.loads.append(given["src"])
        self.loads += [given["href"]] if tag == "link" else []
        self.places += [given["id"]] if "id" in given else []
        if given.get("class") == "runs":
            self.programs.append(given["data-before"])


def test_everything_that_a_page_loads_is_there(site: Path) -> None:
    for file in site.rglob("*.html"):
        for name in Page(file).loads:
            assert (file.parent / name).is_file(), (file.name, name)


def test_links_lead_to_pages_and_places(site: Path) -> None:
    demos = {f"#{name}" for name in (*NAMES, *C_NAMES)}
    for file in site.rglob("*.html"):
        for link in Page(file).links:
            if link.startswith("https:") or link in demos:
                continue
            name, _, place = link.partition("#")
            target = file.parent / name if name else file
            assert target.is_file(), (file.name, link)
            if place:
                assert place in Page(target).places or place in NAMES, (file.name, link)


def test_no_script_and_no_style_comes_from_elsewhere(site: Path) -> None:
    for file in [*site.glob("*.js"), *site.glob("*.css")]:
        assert not re.search(r"https?:", file.read_text("utf-8")), file.name
    for file in site.rglob("*.html"):
        assert not [name for name in Page(file).loads if ":" in name], file.name


def test_modules_import_what_is_there(site: Path) -> None:
    for file in site.glob("*.js"):
        for name in re.findall(r'from "\./([^"]+)"', file.read_text("utf-8")):
            built_later = name == "contents.js" or name.startswith("python/")
            assert built_later or (site / name).is_file(), (file.name, name)


def test_programs_of_the_documentation_follow_what_the_page_says(site: Path) -> None:
    lines = Page(site / "docs" / "lines.html").programs
    assert set(lines) == {"from bgi import *; initgraph(VGA, VGAHI)\n"}
    surfaces = Page(site / "docs" / "surfaces.html").programs
    assert surfaces[0] == "" and surfaces[2].startswith(surfaces[1]) and surfaces[1]
    assert set(Page(site / "docs" / "README.html").programs) == {""}
