"""What tuning found: the best parameters, judged on flights that no trial has flown."""

import json
import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bumpless.campaign.flight import Row
from bumpless.campaign.parameter_path import changes_of
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.summary import Share, share_of
from bumpless.campaign.tune.score import Quality, quality_of, score_gain, score_interval, score_of
from bumpless.campaign.tune.study import ERROR, Fly, finished, reference_of
from bumpless.campaign.tune.values import applied, first, tune_of
from bumpless.config.whole import write_text

if TYPE_CHECKING:
    from optuna import Study

PATCH, NUMBERS = "parameters.toml", "tune.json"
CLEARLY = "clearly better"  # the verdict with which gains may ship


@dataclass(frozen=True)
class Judged:
    """How one set of parameters did on one set of flights."""

    score: float
    low: float  # 95 % interval of the score, flights drawn again and again from these
    high: float
    docked: Share
    quality: Quality


@dataclass(frozen=True)
class Tuned:
    """The best of a search. Held-out flights have numbers that no trial flies."""

    seed: int  # of the campaign
    sampler_seed: int
    trial: int  # from 0, which flew the parameters that the search began with
    trials: int
    failed: tuple[str, ...]  # why, of each trial that could not be flown
    values: dict[str, float]
    present: dict[str, float]  # the same parameters as the search began
    tuning: tuple[int, int]  # first and last number that trials flew
    held_out: tuple[int, int]
    looks: int  # how often the held-out flights have been flown, this time included
    before: Judged  # held-out, with the parameters that the search began with
    after: Judged  # held-out, with the best
    gain: tuple[float, float]  # 95 % interval of how much smaller the held-out score became, flight by flight
    identity: dict[str, str]

    @property
    def verdict(self) -> str:
        """Whether what was found is worth shipping, in a few words."""
        if self.trial == 0:
            return "nothing better found"
        if self.gain[0] > 0.0:
            return CLEARLY
        return "not clearly better" if self.after.score < self.before.score else "not better"

    def as_dict(self) -> dict[str, Any]:
        """For JSON; what was never known is null."""
        return _known(asdict(self) | {"verdict": self.verdict})


def held_out_numbers(prepared: Prepared) -> range:
    """The flights after the last that trials fly."""
    count = prepared.campaign.count
    return range(count, count + tune_of(prepared).held_out)


def judge(study: "Study", prepared: Prepared, fly: Fly) -> Tuned:
    """Fly the held-out set with the first and with the best parameters; once for each best."""
    best, over = study.best_trial, finished(study)
    trial = [t.number for t in over].index(best.number)
    looks, numbers = int(study.user_attrs.get("looks", 0)), held_out_numbers(prepared)
    said = study.user_attrs.get(f"judged {trial}")
    if said is None:
        looks += 1
        study.set_user_attr("looks", looks)
        rows = fly(applied(prepared, first(prepared)), numbers)
        found = rows if trial == 0 else fly(applied(prepared, best.params), numbers)
        said = json.dumps(_compared(study, prepared, rows, found))
        study.set_user_attr(f"judged {trial}", said)
    one = json.loads(said)
    return Tuned(
        seed=prepared.campaign.seed,
        sampler_seed=tune_of(prepared).seed,
        trial=trial,
        trials=len(over),
        failed=tuple(
            f"trial {k}: {t.user_attrs[ERROR]}" for k, t in enumerate(over) if ERROR in t.user_attrs
        ),
        values=dict(best.params),
        present=first(prepared),
        tuning=(0, prepared.campaign.count - 1),
        held_out=(numbers[0], numbers[-1]),
        looks=looks,
        before=_read(one["before"]),
        after=_read(one["after"]),
        gain=tuple(one["gain"]),
        identity=study.user_attrs["identity"],
    )


def _compared(study: "Study", prepared: Prepared, before: list[Row], after: list[Row]) -> dict[str, Any]:
    weights, reference = tune_of(prepared).weights, reference_of(study)
    assert reference is not None
    return {
        "before": asdict(_judged(study, prepared, before)),
        "after": asdict(_judged(study, prepared, after)),
        "gain": score_gain(before, after, weights, reference),
    }


def _judged(study: "Study", prepared: Prepared, rows: list[Row]) -> Judged:
    weights, reference = tune_of(prepared).weights, reference_of(study)
    assert reference is not None
    docked = sum(row["outcome"] == "docked" for row in rows)
    score = score_of(rows, weights, reference)
    low, high = score_interval(rows, weights, reference)
    return Judged(score, low, high, share_of(docked, len(rows)), quality_of(rows))


def _read(one: dict[str, Any]) -> Judged:
    docked, quality = Share(**one.pop("docked")), Quality(**one.pop("quality"))
    return Judged(**one, docked=docked, quality=quality)


def _known(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _known(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_known(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def write(folder: Path, prepared: Prepared, tuned: Tuned) -> None:
    """`parameters.toml`, which `parameters_file` of a campaign takes, and `tune.json`."""
    numbers = json.dumps(tuned.as_dict(), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    write_text(folder / NUMBERS, numbers)
    write_text(folder / PATCH, patch_text(prepared, tuned))


def patch_text(prepared: Prepared, tuned: Tuned) -> str:
    """TOML of the parameters that tuning changed, whole rows, with where they come from."""
    head = [
        f"Found by `bumpless tune` of {prepared.campaign.name}, trial {tuned.trial} of {tuned.trials}.",
        f"Tuned on flights {_said(tuned.tuning)}; judged on {_said(tuned.held_out)}, look {tuned.looks}.",
        f"Docked there: {_docked(tuned.after)}; before: {_docked(tuned.before)}.",
        f"On these flights {tuned.verdict}.",
        *(f"{name}: {value}" for name, value in tuned.identity.items()),
    ]
    lines = [f"# {line}" for line in head]
    for section, table in changes_of(prepared.setups[0].parameters, tuned.values).items():
        lines += ["", f"[{section}]"]
        lines += [f"{key} = {json.dumps(value)}" for key, value in table.items()]  # JSON is TOML here
    return "\n".join(lines) + "\n"


def _said(numbers: tuple[int, int]) -> str:
    return f"{numbers[0]} to {numbers[1]}"


def _docked(judged: Judged) -> str:
    d = judged.docked
    return f"{d.count} of {d.total} ({100 * d.low:.1f} to {100 * d.high:.1f} %)"
