"""What tuning found: the best parameters, judged on flights that no trial has flown."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bumpless.campaign.flight import Row
from bumpless.campaign.parameter_path import changes_of
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.summary import Share, share_of
from bumpless.campaign.tune.score import Quality, quality_of, score_interval, score_of
from bumpless.campaign.tune.study import Fly, applied, present, reference_of
from bumpless.config.whole import write_text

if TYPE_CHECKING:
    from optuna import Study

PATCH, NUMBERS = "parameters.toml", "tune.json"


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

    trial: int
    trials: int
    values: dict[str, float]
    present: dict[str, float]  # the same parameters as they were
    tuning: tuple[int, int]  # first and last number that trials flew
    held_out: tuple[int, int]
    looks: int  # how often the held-out flights have been flown, this time included
    before: Judged  # held-out, with the parameters as they were
    after: Judged  # held-out, with the best
    identity: dict[str, str]

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        return asdict(self)


def held_out_numbers(prepared: Prepared) -> range:
    """The flights after the last that trials fly."""
    tune, count = prepared.campaign.tune, prepared.campaign.count
    assert tune is not None
    return range(count, count + tune.held_out)


def judge(study: "Study", prepared: Prepared, fly: Fly) -> Tuned:
    """Fly the held-out set with the parameters as they were and with the best; once for each best."""
    trial, looks = study.best_trial, int(study.user_attrs.get("looks", 0))
    said = study.user_attrs.get(f"judged {trial.number}")
    if said is None:
        looks += 1
        study.set_user_attr("looks", looks)
        numbers = held_out_numbers(prepared)
        flown = [fly(applied(prepared, values), numbers) for values in (present(prepared), trial.params)]
        said = json.dumps([asdict(_judged(study, prepared, rows)) for rows in flown])
        study.set_user_attr(f"judged {trial.number}", said)
    before, after = (_read(one) for one in json.loads(said))
    numbers, count = held_out_numbers(prepared), prepared.campaign.count
    return Tuned(
        trial=trial.number,
        trials=len(study.get_trials(deepcopy=False)),
        values=dict(trial.params),
        present=present(prepared),
        tuning=(0, count - 1),
        held_out=(numbers[0], numbers[-1]),
        looks=looks,
        before=before,
        after=after,
        identity=study.user_attrs["identity"],
    )


def _judged(study: "Study", prepared: Prepared, rows: list[Row]) -> Judged:
    tune, reference = prepared.campaign.tune, reference_of(study)
    assert tune is not None and reference is not None
    docked = sum(row["outcome"] == "docked" for row in rows)
    score = score_of(rows, tune.weights, reference)
    low, high = score_interval(rows, tune.weights, reference)
    return Judged(score, low, high, share_of(docked, len(rows)), quality_of(rows))


def _read(one: dict[str, Any]) -> Judged:
    docked, quality = Share(**one.pop("docked")), Quality(**one.pop("quality"))
    return Judged(**one, docked=docked, quality=quality)


def write(folder: Path, prepared: Prepared, tuned: Tuned) -> None:
    """`parameters.toml`, which `parameters_file` of a campaign takes, and `tune.json`."""
    numbers = json.dumps(tuned.as_dict(), indent=1, ensure_ascii=False) + "\n"
    write_text(folder / NUMBERS, numbers)
    write_text(folder / PATCH, patch_text(prepared, tuned))


def patch_text(prepared: Prepared, tuned: Tuned) -> str:
    """TOML of the parameters that tuning changed, whole rows, with where they come from."""
    head = [
        f"Found by `bumpless tune` of {prepared.campaign.name}, trial {tuned.trial} of {tuned.trials}.",
        f"Tuned on flights {_said(tuned.tuning)}; judged on {_said(tuned.held_out)}, look {tuned.looks}.",
        f"Docked there: {_docked(tuned.after)}; before: {_docked(tuned.before)}.",
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
