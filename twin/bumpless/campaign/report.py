"""Write what a campaign found beside its flights: `index.html` and `summary.json`."""

import json

from bumpless.campaign.page import page_of
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.store import Store, manifest
from bumpless.campaign.summary import Summary, summary_of
from bumpless.config.whole import write_text

PAGE, NUMBERS = "index.html", "summary.json"


def write_report(prepared: Prepared, store: Store, file: str) -> Summary:
    """Page and numbers of all flights that are stored. file: the campaign file, as its commands name it."""
    table = store.table()
    summary = summary_of(table)
    numbers = {**manifest(prepared), "summary": summary.as_dict()}
    text = json.dumps(numbers, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    write_text(store.folder / NUMBERS, text)
    write_text(store.folder / PAGE, page_of(prepared, table, summary, file))
    return summary
