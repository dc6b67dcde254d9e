"""Tables as HTML."""

import re
from collections.abc import Sequence
from html import escape
from typing import Any

from bumpless_paper.report.content import Comparison, Grid, relative_change
from bumpless_paper.report.labels import label
from bumpless_paper.report.ticks import number, percent

MANY = 6  # columns from which on a table is set tightly


def table_html(table: Comparison | Grid) -> str:
    """One table with its caption."""
    body = _comparison(table) if isinstance(table, Comparison) else _grid(table)
    caption = f"<figcaption>{escape(table.caption)}</figcaption>" if table.caption else ""
    title = f"<h3>{escape(table.title)}</h3>"
    return f'<figure id="{table.id}">{title}<div class="wide">{body}</div>{caption}</figure>'


def _comparison(table: Comparison) -> str:
    head = "".join(f"<th>{escape(label(column))}</th>" for column in table.columns)
    many = ' class="many"' if len(table.columns) > MANY else ""
    lines = []
    for row, (paper, ours, spread) in table.rows.items():
        cells = []
        for k in range(len(table.columns)):
            around = None if spread is None else spread[k]
            if around is not None and abs(around) < 1e-9 * abs(ours[k] or 1.0):
                around = 0.0  # all alike but for rounding
            wide = "" if around is None else f" <small>±{number(float(around), 2)}</small>"
            change = percent(relative_change(paper[k], ours[k]))
            cells.append(
                f"<td><span class=paper>{number(paper[k])}</span><b>{number(ours[k])}</b>{wide}"
                f"<span class=change>{change}</span></td>"
            )
        lines.append(f"<tr><th>{escape(row)}</th>{''.join(cells)}</tr>")
    words = "<span class=paper>paper</span> <b>ours</b> <span class=change>relative change</span>"
    key = f'<p class="key">{words}</p>'
    return f"{key}<table{many}><thead><tr><th></th>{head}</tr></thead><tbody>{''.join(lines)}</tbody></table>"


_NUMBER = r"[−+\-]?[\d ,.]+(e[−+\-]?\d+)?( ?[%s°])?"
NUMERIC = re.compile(rf"^({_NUMBER}( […/] {_NUMBER})?|[<>] [−+\d ]+%|–)?$")


def _grid(table: Grid) -> str:
    numeric = [_is_numeric([row[k] for row in table.rows]) for k in range(len(table.columns))]
    head = "".join(
        f'<th class="{"num" if of else "word"}">{escape(label(column))}</th>'
        for column, of in zip(table.columns, numeric, strict=True)
    )
    lines = []
    for row in table.rows:
        cells = "".join(
            f'<td class="{"num" if of else "word"}">{_lines(value)}</td>'
            for value, of in zip(row[1:], numeric[1:], strict=True)
        )
        first = label(row[0]) if isinstance(row[0], str) else row[0]
        lines.append(f"<tr><th>{_lines(first)}</th>{cells}</tr>")
    many = ' class="many"' if len(table.columns) > MANY else ""
    return f"<table{many}><thead><tr>{head}</tr></thead><tbody>{''.join(lines)}</tbody></table>"


def _is_numeric(cells: Sequence[Any]) -> bool:
    """Whether every cell of a column is a number, a percentage or nothing."""
    texts = [line for cell in cells for line in number(cell).split("\n")]
    return any(text not in ("", "–") for text in texts) and all(NUMERIC.match(text) for text in texts)


def _lines(value: Any) -> str:
    return escape(number(value)).replace("\n", "<br>")
