"""Write what a campaign found beside its flights: `index.html` and `summary.json`."""

import json
from pathlib import Path

from bumpless.campaign.page import page_of
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.store import Store, manifest
from bumpless.campaign.summary import Summary, summary_of

PAGE, NUMBERS = "index.html", "summary.json"


def write_report(prepared: Prepared, store: Store, file: str) -> Summary:
    """Page and numbers of all flights that are stored. file: the campaign file, as its commands name it."""
    table = store.table()
    summary = summary_of(table)
    numbers = {**manifest(prepared), "summary": summary.as_dict()}
    text = json.dumps(numbers, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    _replace(store.folder / NUMBERS, text)
    _replace(store.folder / PAGE, page_of(prepared, table, summary, file))
    return summary


def _replace(path: Path, text: str) -> None:
    part = path.with_name(f"{path.name}.part")
    part.write_text(text, encoding="utf-8")
    part.replace(path)
