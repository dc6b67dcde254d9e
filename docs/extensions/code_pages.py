"""Links to files of the repository become links to pages of the site, one per file, with an anchor per line.

In the Markdown a link reads `[text](../twin/bumpless/control/pid.py#L12)`, which a forge or an editor follows
as it is. Here the file is drawn with Pygments under `code/`, so that the site needs no forge and no network.
"""

import posixpath
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_for_filename
from pygments.lexers.special import TextLexer
from pygments.util import ClassNotFound
from sphinx.application import Sphinx
from sphinx.util import logging

ROOT = Path(__file__).resolve().parents[2]
SCHEME = "code:"  # stands for the repository's root until the link's page is known
LINK = re.compile(r"\]\(((?:\.\./)+[^)\s#]+)(#L\d+)?\)")
FOLDER = "code"
log = logging.getLogger(__name__)


def mark_links(app: Sphinx, docname: str, source: list[str]) -> None:
    """Mark links that leave docs/; those to other pages stay as they are."""

    def marked(found: re.Match[str]) -> str:
        path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(docname), found[1]))
        return (
            found[0]
            if path.startswith("docs/") and path.endswith(".md")
            else f"]({SCHEME}{path}{found[2] or ''})"
        )

    source[0] = LINK.sub(marked, source[0])


def point_links(app: Sphinx, tree: nodes.document, docname: str) -> None:
    """Point marked links to their files' pages."""
    for link in tree.findall(nodes.reference):
        target = link.get("refuri", "")
        if not target.startswith(SCHEME):
            continue
        path, _, line = target.removeprefix(SCHEME).partition("#")
        if not (ROOT / path).is_file():
            log.warning("%s is not a file of the repository", path, location=link)
            continue
        linked(app).add(path)
        page = app.builder.get_relative_uri(docname, f"{FOLDER}/{path}")
        link["refuri"] = page + (f"#{line}" if line else "")
        link["internal"] = True


def linked(app: Sphinx) -> set[str]:
    """The files that some page links to, as paths from the repository's root."""
    if not hasattr(app.env, "bumpless_linked"):
        app.env.bumpless_linked = set()  # type: ignore[attr-defined]
    return app.env.bumpless_linked  # type: ignore[attr-defined]


def pages(app: Sphinx) -> Iterator[tuple[str, dict[str, Any], str]]:
    """One page for each linked file."""
    formatter = HtmlFormatter(linenos="inline", lineanchors="L", anchorlinenos=True, cssclass="highlight")
    for path in sorted(linked(app)):
        text = (ROOT / path).read_text(encoding="utf-8")
        try:
            lexer = get_lexer_for_filename(path)
        except ClassNotFound:
            lexer = TextLexer()
        # Pygments writes L-12; the links say L12, as forges do.
        body = highlight(text, lexer, formatter).replace('"L-', '"L').replace('"#L-', '"#L')
        yield (
            f"{FOLDER}/{path}",
            {"title": path, "body": f'<h1>{path}</h1><div class="code-page">{body}</div>'},
            "page.html",
        )


def setup(app: Sphinx) -> dict[str, Any]:
    """Sphinx calls this."""
    app.connect("source-read", mark_links)
    app.connect("doctree-resolved", point_links)
    app.connect("html-collect-pages", pages)
    return {"parallel_read_safe": False, "parallel_write_safe": False}
