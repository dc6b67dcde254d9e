"""Allocator by ramp, the paper's S2, S3 and S4 each flown with the gains that are best for them.

All rows fly the campaign `CAMPAIGN`: docking into a current, on vehicles whose fins, screws and sensors the
autopilot does not know. `make fair`, which is `python -m bumpless_paper.study.fair [ROW ...]`, searches the
gains of `SEARCHED`, or of these rows, with that campaign's `tune`: the same parameters, bounds, flights,
trials, beginning and score. A search that was stopped goes on where it was. What is found goes into `FOUND`.
`judge` flies the rows with `gains` on flights that no search has seen; other rows fly those that ship.
"""

import json
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from bumpless.campaign.cluster import kept
from bumpless.campaign.engine import in_order
from bumpless.campaign.flight import FlyNumbers, Row
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.read import load_campaign
from bumpless.campaign.summary import share_of
from bumpless.campaign.tune import journal, result, study
from bumpless.campaign.tune.values import applied
from bumpless.config.mission.shipped import missions_folder
from bumpless_paper.study.outcomes import GENTLE, HELD_OUT, Progress
from bumpless_paper.study.scenarios import HARD, Overrides, merged

CAMPAIGN, FOUND = "tune_ts100.yaml", Path(__file__).with_name("fair.json")
SEARCHES = Path("build/fair")  # one folder a row


@dataclass(frozen=True)
class Variant:
    """One row: what differs from the vehicle as it ships."""

    title: str
    overrides: Overrides


def _allocator(name: str, **more: Any) -> Overrides:
    return {"allocation": {"allocator": name, **more}}


_PID = _allocator("pid_direct", direct_map="thrust_in_flow")
_NO_RAMP: Overrides = {"bumpless": {"ramp": False}}
ROWS: dict[str, Variant] = {
    "pid": Variant("PID direct, no ramp", merged(_PID, _NO_RAMP)),
    "pid_ramp": Variant("PID direct, ramp", _PID),
    "wls": Variant("WLS, no ramp (S2)", merged(_allocator("wls"), _NO_RAMP)),
    "wls_ramp": Variant("WLS, ramp", _allocator("wls")),
    "hard": Variant("MD-CA, hard (S3)", merged(_allocator("mdca"), HARD)),
    "mdca_ramp": Variant("MD-CA, ramp (S4)", _allocator("mdca")),
}
SEARCHED = ("mdca_ramp", "hard", "wls")  # S4, S3, S2
MEDIANS = (
    "wrench_error_rms", "step_fr", "late_step_fr", "step_rh", "late_step_rh", "forward_depth_m_rms",
    "reverse_depth_m_rms", "hover_depth_m_rms", "reverse_cross_m_rms", "hover_heading_deg_rms", "energy_j",
    "fin_travel_deg", "reversals",
)  # fmt: skip


@cache
def campaign() -> Prepared:
    """What every row flies."""
    return load_campaign(missions_folder() / "campaigns" / CAMPAIGN)


def prepared_for(name: str) -> Prepared:
    """The campaign with a row's allocator and ramp."""
    return campaign().with_parameters(ROWS[name].overrides)


@cache
def found() -> dict[str, Any]:
    """What the search found, by row."""
    return json.loads(FOUND.read_text(encoding="utf-8"))["rows"]


def gains(name: str) -> dict[str, float]:
    """What a row flies: what its search found if held-out flights find it clearly better, else its beginning.

    Nothing for a row that no search was made for.
    """
    if name not in found():
        return {}
    row = found()[name]
    return row["values"] if row["verdict"] == result.CLEARLY else row["present"]


def search(name: str, workers: int, folder: Path = SEARCHES) -> dict[str, Any]:
    """What `bumpless tune` finds for a row, and the held-out flights with it and without."""
    prepared, fly = prepared_for(name), study.flier(kept(workers))
    with journal.opened(folder / name, prepared, resume=True) as found:
        study.search(found, prepared, fly)
        return result.judge(found, prepared, fly).as_dict()


def judge(
    count: int = 100,
    workers: int = 1,
    progress: Progress = None,
    names: Sequence[str] = tuple(ROWS),
) -> dict[str, Any]:
    """Every row with its own gains on the same `count` flights; plain values fit for JSON."""
    jobs = [(name, number) for name in names for number in range(count)]
    rows = in_order(jobs, _fly, workers, progress)
    by_name = {name: rows[k * count : (k + 1) * count] for k, name in enumerate(names)}
    return {
        "flights": count,
        "seed": HELD_OUT,
        "rows": {name: summed(by_name[name]) | {"title": ROWS[name].title} for name in names},
    }


def _fly(job: tuple[str, int]) -> Row:
    return FlyNumbers(_tuned(job[0]))([job[1]])[0]


@cache
def _tuned(name: str) -> Prepared:
    prepared = applied(prepared_for(name), gains(name))
    return replace(prepared, campaign=replace(prepared.campaign, seed=HELD_OUT))


def summed(rows: Sequence[Row]) -> dict[str, Any]:
    """One row of the table: endings, docked with its interval, medians, and how often it was gentle."""
    endings = [row["outcome"] for row in rows]
    docked = share_of(endings.count("docked"), len(rows))
    gentle = {
        name: float(np.mean([row[f"late_step_{name}"] <= GENTLE for row in rows])) for name in ("fr", "rh")
    }
    return {
        "endings": {word: endings.count(word) for word in dict.fromkeys(sorted(endings))},
        "docked": docked.share,
        "docked_interval": (docked.low, docked.high),
        "gentle": gentle,  # NaN, no such switch, is not gentle
        "median": {name: _median([row[name] for row in rows]) for name in MEDIANS},
    }


def _median(values: Sequence[float]) -> float | None:
    known = np.array(values, float)
    known = known[np.isfinite(known)]
    return float(np.median(known)) if len(known) else None


def main(names: Sequence[str]) -> None:
    """Search these rows, `SEARCHED` when none is named, and write what was found."""
    rows = dict(found()) if FOUND.exists() else {}
    for name in names or SEARCHED:
        rows[name] = search(name, os.cpu_count() or 1)
        about = {"campaign": CAMPAIGN, "rows": {key: rows[key] for key in ROWS if key in rows}}
        FOUND.write_text(json.dumps(about, indent=1) + "\n", encoding="utf-8")
        print(f"{ROWS[name].title}: {rows[name]['verdict']}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
