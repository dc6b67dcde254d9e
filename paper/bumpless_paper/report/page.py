"""The page: self-contained HTML, light and dark, no script and no outside address."""

from collections.abc import Sequence
from html import escape
from pathlib import Path

from bumpless_paper.report.content import Figure, Panel, Part
from bumpless_paper.report.plot import WIDTH, panel_svg
from bumpless_paper.report.solid import solid_svg
from bumpless_paper.report.table_html import table_html

STYLE = Path(__file__).with_name("page.css")


def page_of(parts: Sequence[Part], made_by: dict[str, str], summary: str = "") -> str:
    """All parts as one HTML text. made_by: what produced it, name -> version or hash."""
    style = STYLE.read_text(encoding="utf-8")
    links = "".join(f'<a href="#{part.id}">{escape(part.title)}</a>' for part in parts)
    rows = "".join(
        f"<tr><th>{escape(k)}</th><td><code>{escape(v)}</code></td></tr>" for k, v in made_by.items()
    )
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f"<title>Bumpless: the paper, reproduced</title><style>{style}</style></head>"
        "<body><header><h1>The paper, reproduced</h1>"
        "<p>Gao et al., <em>Bumpless Multi-Mode Control Allocation for Over-Actuated AUV Docking</em>, "
        "J. Mar. Sci. Eng. 2026, 14(5), 516, doi:10.3390/jmse14050516, beside what Bumpless finds.</p>"
        f"<nav>{links}</nav>{summary}</header><main>{''.join(_part(part) for part in parts)}</main>"
        f'<footer><h2>What produced this page</h2><div class="wide"><table>{rows}</table>'
        "</div></footer></body></html>"
    )


def _part(part: Part) -> str:
    text = "".join(f"<p>{escape(line)}</p>" for line in part.text.split("\n") if line)
    tables = "".join(table_html(table) for table in part.tables)
    figures = "".join(_figure(figure) for figure in part.figures)
    notes = "".join(f"<li>{escape(note)}</li>" for note in part.notes)
    told = f"<ul>{notes}</ul>" if notes else ""
    return f'<section id="{part.id}"><h2>{escape(part.title)}</h2>{text}{tables}{told}{figures}</section>'


def _figure(figure: Figure) -> str:
    width = WIDTH if figure.columns == 1 else WIDTH * 11 // 20
    shown = "".join(
        f"<div>{panel_svg(panel, width) if isinstance(panel, Panel) else solid_svg(panel)}</div>"
        for panel in figure.panels
    )
    return (
        f'<figure id="{figure.id}"><h3>{escape(figure.title)}</h3>'
        f'<div class="panels" style="--n:{figure.columns}">{shown}</div>'
        f'<figcaption>{escape(figure.caption)} <a href="{figure.id}.csv">{figure.id}.csv</a>'
        "</figcaption></figure>"
    )
