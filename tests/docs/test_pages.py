"""The pages hold together: links lead somewhere, the README is short, the site needs no network."""

import re
from pathlib import Path

import pytest

from docs import build

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.rglob("*.md"))]
LINK = re.compile(r"\]\(([^)\s]+)\)")
ELSEWHERE = re.compile(r"<(?:script|link|img|iframe|source)[^>]*?(?:src|href)=.(?:https?:)?//")


def anchors(page: Path) -> set[str]:
    """What can follow # in a link to a page: its headings as a forge names them."""
    heads = re.findall(r"^#+ (.+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_links_lead_somewhere(page: Path) -> None:
    """Protects: a reader in the repository, without the site, finds every page, file and line named."""
    dead = []
    for link in LINK.findall(page.read_text(encoding="utf-8")):
        if link.startswith(("http", "mailto:", "doi:")):
            continue
        path, _, place = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.is_file():
            dead.append(link)
        elif place and target.suffix == ".md":
            dead += [] if place in anchors(target) else [link]
        elif place:
            dead += [] if int(place[1:]) <= len(target.read_text(encoding="utf-8").splitlines()) else [link]
    assert dead == []


def test_the_readme_is_a_front_door() -> None:
    """Protects: the README stays short; what is long has a page of its own."""
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= 120


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built anew; a warning of Sphinx fails the build."""
    folder = tmp_path_factory.mktemp("site")
    build.make(folder)
    return folder


def test_the_site_needs_no_network(site: Path) -> None:
    """Protects: the Help of a vehicle's laptop works at sea: no font, script or picture from elsewhere."""
    for page in site.rglob("*.html"):
        assert not ELSEWHERE.findall(page.read_text(encoding="utf-8")), page.name
    for style in site.rglob("*.css"):
        assert not re.findall(r"url\([\"']?(?:https?:)?//|@import", style.read_text(encoding="utf-8"))


def test_the_site_shows_the_line_of_an_equation(site: Path) -> None:
    """Protects: a link of the method page leads to a line that exists, within the site."""
    page = (site / "method.html").read_text(encoding="utf-8")
    links = re.findall(r'href="(code/[^"#]+\.html)#(L\d+)"', page)
    assert len(links) > 20
    for path, line in links:
        assert f'id="{line}"' in (site / path).read_text(encoding="utf-8")
    assert "<math" in page


def test_a_page_that_shows_a_file_is_built_anew_when_the_file_changes(site: Path) -> None:
    """Protects: Help never shows code that is no longer the code."""
    shown = build.shown_files(site)
    assert "twin/bumpless/contract/bumpless.proto" in shown
    assert set(shown) <= set(build.fingerprint(shown))
