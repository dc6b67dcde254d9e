"""The page from its template and a campaign's table."""

import shlex
from pathlib import Path
from typing import TYPE_CHECKING

from bumpless.campaign.page.capture import capture_pictures
from bumpless.campaign.page.plots import current_map, quantity_bars
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.quantities import QUANTITIES
from bumpless.campaign.summary import Share, Summary
from bumpless.config.declare import as_table

if TYPE_CHECKING:
    import pyarrow as pa

TEMPLATES = Path(__file__).parent


def page_of(prepared: Prepared, table: "pa.Table", summary: Summary, file: str) -> str:
    """HTML. file: the campaign file as the commands to replay a flight name it."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(TEMPLATES), autoescape=True, undefined=StrictUndefined, trim_blocks=True
    )
    environment.filters |= {"percent": _percent, "interval": _interval, "short": _short}
    campaign = prepared.campaign
    return environment.get_template("page.html.jinja").render(
        campaign=campaign,
        summary=summary,
        identity=prepared.identity(),
        setups=prepared.setups,
        current_map=current_map(table),
        quantity_bars=quantity_bars(table),
        captures=capture_pictures(prepared.setups),
        draws=[(name, _said(d), QUANTITIES[name]) for name, d in campaign.draw.items()],
        commands={row["number"]: replay(file, row["number"]) for row in summary.worst},
    )


def replay(file: str, number: int) -> str:
    """The command that flies one flight of the campaign again and keeps its log."""
    return f"bumpless run {shlex.quote(file)} --draw {number} --out flight-{number}.mcap"


def _said(distribution: object) -> str:
    kind, values = next(iter(as_table(distribution).items()))
    return f"{kind} " + ", ".join(
        f"{value:g}" if isinstance(value, float | int) else value for value in values
    )


def _percent(share: float) -> str:
    return "–" if share != share else f"{100.0 * share:.1f} %"


def _interval(share: Share) -> str:
    return f"{100.0 * share.low:.1f} to {100.0 * share.high:.1f} %"


def _short(value: float) -> str:
    return "–" if value != value else f"{value:.3g}"
