"""What `bumpless tune` found for every vehicle, from results/tuning/: part of docs/tuning.md."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from bumpless.campaign.parameter_path import value_at
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.read import load_campaign
from bumpless.campaign.tune.journal import identity_of
from bumpless.campaign.tune.result import CLEARLY
from bumpless.config.parameters import Parameters
from docs.generate.markdown import table

ROOT = Path(__file__).parents[2]
FOUND, CAMPAIGNS = ROOT / "results" / "tuning", ROOT / "missions" / "campaigns"
BEGIN, END = "<!-- tuning:begin -->", "<!-- tuning:end -->"
SINCE = {"missions": "mission", "parameters": "control"}  # of a search's identity
SHIPS_WITHIN = 1e-3  # a vehicle's file has four digits of what was found


def filled(page: str) -> str:
    """The page with its table made anew. ValueError when it has no place for it."""
    head, begin, rest = page.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"docs/tuning.md has no {BEGIN} ... {END}")
    return f"{head}{BEGIN}\n{results()}{END}{tail}"


def results() -> str:
    """Three tables: the searches, what they were worth on held-out flights, and the gains they found."""
    runs = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(FOUND.glob("*.json"))}
    files = {name: load_campaign(CAMPAIGNS / f"tune_{name}.yaml") for name in runs}
    searches = table(
        ["vehicle", "search", "held out", "verdict", "shipped", "changed since"],
        [_search(name, run, files[name]) for name, run in runs.items()],
    )
    worth = table(
        ["vehicle", "docked before", "docked after", "score before", "score after", "score smaller by",
         "tracking", "steps", "energy"],
        [_worth(name, run) for name, run in runs.items()],
    )  # fmt: skip
    gains = table(
        ["vehicle", "parameter", "before", "found"],
        [
            [name, f"`{path}`", f"{run['present'][path]:.4g}", f"{value:.4g}"]
            for name, run in runs.items()
            for path, value in run["values"].items()
        ],
    )
    return f"{searches}\n{worth}\n{gains}"


def _search(name: str, run: dict[str, Any], file: Prepared) -> list[str]:
    flights = run["tuning"][1] - run["tuning"][0] + 1
    now = identity_of(file)
    changed = [word for key, word in SINCE.items() if run["identity"][key] != now[key]]
    return [
        name,
        f"{run['trials']} trials of {flights} flights, campaign seed {run['seed']}, sampler seed "
        f"{run['sampler_seed']}",
        f"{run['held_out'][1] - run['held_out'][0] + 1} flights, look {run['looks']}",
        run["verdict"],
        shipped(run, file.setups[0].parameters),
        " and ".join(changed) or "nothing",
    ]


def shipped(run: dict[str, Any], now: Parameters) -> str:
    """yes: flown as found. kept: flown as before, for nothing clearly better was found. no: neither."""
    if run["trial"] and _flown(run["values"], now):
        return "yes"
    return "kept" if run["verdict"] != CLEARLY and _flown(run["present"], now) else "no"


def _flown(values: Mapping[str, float], now: Parameters) -> bool:
    return all(
        abs(value_at(now, path) - value) <= SHIPS_WITHIN * abs(value) for path, value in values.items()
    )


def _worth(name: str, run: dict[str, Any]) -> list[str]:
    before, after, (low, high) = run["before"], run["after"], run["gain"]
    return [
        name,
        *(_docked(one) for one in (before, after)),
        *(f"{one['score']:.2f} ({one['low']:.2f} to {one['high']:.2f})" for one in (before, after)),
        f"{low:.2f} to {high:.2f}",
        *(_change(before["quality"][k], after["quality"][k]) for k in ("tracking", "smoothness", "cost")),
    ]


def _change(before: float | None, after: float | None) -> str:
    return "unknown" if not before or after is None else f"{100 * (after / before - 1):+.0f} %"


def _docked(one: dict[str, Any]) -> str:
    d = one["docked"]
    return f"{d['count']} of {d['total']} ({100 * d['low']:.0f} to {100 * d['high']:.0f} %)"
