"""Tables as HTML."""

from html import escape

from twin.report.content import Comparison, Grid, relative_change
from twin.report.ticks import number, percent


def table_html(table: Comparison | Grid) -> str:
    """One table with its caption."""
    body = _comparison(table) if isinstance(table, Comparison) else _grid(table)
    caption = f"<figcaption>{escape(table.caption)}</figcaption>" if table.caption else ""
    title = f"<h3>{escape(table.title)}</h3>"
    return f'<figure id="{table.id}">{title}<div class="wide">{body}</div>{caption}</figure>'


def _comparison(table: Comparison) -> str:
    head = "".join(f"<th>{escape(column)}</th>" for column in table.columns)
    lines = []
    for label, (paper, ours, spread) in table.rows.items():
        cells = []
        for k in range(len(table.columns)):
            around = None if spread is None else spread[k]
            wide = "" if around is None else f" <small>±{number(float(around), 2)}</small>"
            change = percent(relative_change(paper[k], ours[k]))
            cells.append(
                f"<td><span class=paper>{number(paper[k])}</span><b>{number(ours[k])}</b>{wide}"
                f"<span class=change>{change}</span></td>"
            )
        lines.append(f"<tr><th>{escape(label)}</th>{''.join(cells)}</tr>")
    words = "<span class=paper>paper</span> <b>ours</b> <span class=change>relative change</span>"
    key = f'<p class="key">{words}</p>'
    return f"{key}<table><thead><tr><th></th>{head}</tr></thead><tbody>{''.join(lines)}</tbody></table>"


def _grid(table: Grid) -> str:
    head = "".join(f"<th>{escape(column)}</th>" for column in table.columns)
    lines = []
    for row in table.rows:
        cells = "".join(
            f"<td class={'word' if isinstance(value, str) else 'num'}>{escape(number(value))}</td>"
            for value in row[1:]
        )
        lines.append(f"<tr><th>{escape(number(row[0]))}</th>{cells}</tr>")
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(lines)}</tbody></table>"
