"""What `bumpless tune` found for every vehicle, from results/tuning/: part of docs/tuning.md."""

import json
from pathlib import Path
from typing import Any

from bumpless.campaign.parameter_path import value_at
from bumpless.campaign.read import load_campaign
from docs.generate.markdown import table

ROOT = Path(__file__).parents[2]
FOUND, CAMPAIGNS = ROOT / "results" / "tuning", ROOT / "missions" / "campaigns"
BEGIN, END = "<!-- tuning:begin -->", "<!-- tuning:end -->"


def filled(page: str) -> str:
    """The page with its table made anew. ValueError when it has no place for it."""
    head, begin, rest = page.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"docs/tuning.md has no {BEGIN} ... {END}")
    return f"{head}{BEGIN}\n{results()}{END}{tail}"


def results() -> str:
    """Two tables: what the search was worth on held-out flights, and the gains that it found."""
    runs = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(FOUND.glob("*.json"))}
    worth = table(
        ["vehicle", "search", "held out", "docked before", "docked after", "score before", "score after",
         "tracking", "steps", "energy", "shipped"],
        [_worth(name, run) for name, run in runs.items()],
    )  # fmt: skip
    gains = table(
        ["vehicle", "parameter", "before", "found"],
        [
            [name, f"`{path}`", f"{before:.4g}", f"{value:.4g}"]
            for name, run in runs.items()
            for (path, value), before in zip(run["values"].items(), run["present"].values(), strict=True)
        ],
    )
    return f"{worth}\n{gains}"


def _worth(name: str, run: dict[str, Any]) -> list[str]:
    flights = run["tuning"][1] - run["tuning"][0] + 1
    prepared = load_campaign(CAMPAIGNS / f"tune_{name}.yaml")
    tune, parameters = prepared.campaign.tune, prepared.setups[0].parameters
    seed = tune.seed if tune else 0
    ships = all(
        abs(value_at(parameters, path) - value) <= 1e-3 * abs(value) for path, value in run["values"].items()
    )
    before, after = run["before"], run["after"]
    return [
        name,
        f"{run['trials']} trials of {flights} flights, campaign seed {prepared.campaign.seed}, sampler seed "
        f"{seed}",
        f"{run['held_out'][1] - run['held_out'][0] + 1} flights, look {run['looks']}",
        *(_docked(one) for one in (before, after)),
        *(f"{one['score']:.2f} ({one['low']:.2f} to {one['high']:.2f})" for one in (before, after)),
        *(
            f"{100 * (after['quality'][k] / before['quality'][k] - 1):+.0f} %"
            for k in ("tracking", "smoothness", "cost")
        ),
        "yes" if ships else "no",
    ]


def _docked(one: dict[str, Any]) -> str:
    d = one["docked"]
    return f"{d['count']} of {d['total']} ({100 * d['low']:.0f} to {100 * d['high']:.0f} %)"
