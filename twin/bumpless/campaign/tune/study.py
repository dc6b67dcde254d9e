"""The search itself: trial after trial, each flown by all workers.

Every trial's sampler is seeded by how many trials came before, so a search that was killed and resumed takes
the same steps as one that was not, on any number of workers, and a longer one begins with a shorter one's.
"""

import json
import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from bumpless.campaign.cluster import cores_of
from bumpless.campaign.declaration import Search, Tune
from bumpless.campaign.draws import bits
from bumpless.campaign.engine import answers, in_chunks
from bumpless.campaign.flight import FlightError, FlyNumbers, Row
from bumpless.campaign.parameter_path import value_at
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.tune.score import Quality, endings, quality_of, score_of
from bumpless.campaign.tune.values import applied, first, tune_of
from bumpless.config.parameters import ParameterError

if TYPE_CHECKING:
    from distributed import Client
    from optuna import Study, Trial
    from optuna.trial import FrozenTrial

RACES = 4  # a trial is given up after a part of its flights when the rest can't save it
ROUNDS = 2  # chunks per worker: a part has few flights, and each chunk costs as much as one of them
AT_RANDOM = 10  # trials before the sampler learns from them
ERROR = "error"  # of a trial that could not be flown: why
Progress = Callable[[int, int, str], None]
Fly = Callable[[Prepared, Sequence[int]], list[Row]]


def flier(client: "Client") -> Fly:
    """Flies numbers of a campaign on a cluster; rows in the order of the numbers."""

    def fly(prepared: Prepared, numbers: Sequence[int]) -> list[Row]:
        chunks = in_chunks(numbers, cores_of(client), ROUNDS)
        found = answers(client, FlyNumbers(prepared), dict(enumerate(chunks)))
        return sorted((row for _, rows in found for row in rows), key=lambda row: row["number"])

    return fly


def search(study: "Study", prepared: Prepared, fly: Fly, progress: Progress | None = None) -> None:
    """Trials until there are as many as declared; the first is of the parameters that the search begins with.

    A trial whose parameters don't fit each other, or of which a flight can't be flown, has failed and counts
    as one. Raises FlightError when that is the first, for there is nothing to measure others by.
    """
    from optuna.trial import TrialState

    tune = tune_of(prepared)
    for left in study.get_trials(deepcopy=False, states=(TrialState.RUNNING, TrialState.WAITING)):
        study.tell(left.number, state=TrialState.FAIL)
    while (count := len(finished(study))) < tune.trials:
        study.sampler = _sampler(tune, count)
        if count == 0:
            study.enqueue_trial(first(prepared))
        trial = study.ask()
        asked = {path: _suggested(trial, path, tune.search[path], prepared) for path in sorted(tune.search)}
        try:
            value = _fly_trial(study, trial, prepared, asked, fly)
        except (FlightError, ParameterError) as error:
            if count == 0:
                raise
            trial.set_user_attr(ERROR, str(error))
            study.tell(trial, state=TrialState.FAIL)
        else:
            study.tell(trial, value, state=None if value is not None else TrialState.PRUNED)
        if progress:
            progress(count + 1, tune.trials, f"best score {study.best_value:.3f}")


def finished(study: "Study") -> "list[FrozenTrial]":
    """Trials that are over, in their order; what a kill cut off is none."""
    from optuna.trial import TrialState

    over = (TrialState.COMPLETE, TrialState.PRUNED)
    return [t for t in study.get_trials(deepcopy=False) if t.state in over or ERROR in t.user_attrs]


def reference_of(study: "Study") -> Quality | None:
    """The quality of the first trial, by which the others are measured."""
    said = study.user_attrs.get("reference")
    return None if said is None else Quality(**json.loads(said))


def _fly_trial(
    study: "Study", trial: "Trial", prepared: Prepared, values: dict[str, float], fly: Fly
) -> float | None:
    """Score of a trial; None when it was given up."""
    count, changed, reference = prepared.campaign.count, applied(prepared, values), reference_of(study)
    best = study.best_value if finished(study) else math.inf
    rows: list[Row] = []
    for race in range(RACES):
        part = range(count * race // RACES, count * (race + 1) // RACES)
        rows += fly(changed, part) if part else []
        trial.report(endings(rows) * count / max(1, len(rows)), race)
        if race < RACES - 1 and endings(rows) > best:
            return None
    if reference is None:
        reference = quality_of(rows)
        study.set_user_attr("reference", json.dumps(vars(reference)))
    trial.set_user_attr("docked", sum(row["outcome"] == "docked" for row in rows))
    return score_of(rows, tune_of(prepared).weights, reference)


def _suggested(trial: "Trial", path: str, s: Search, prepared: Prepared) -> float:
    if isinstance(value_at(prepared.setups[0].parameters, path), int):
        return trial.suggest_int(path, round(s.low), round(s.high), log=s.log)
    return trial.suggest_float(path, s.low, s.high, log=s.log)


def _sampler(tune: Tune, count: int) -> Any:
    from optuna.samplers import TPESampler

    return TPESampler(n_startup_trials=AT_RANDOM, seed=bits(tune.seed, count, "sampler") >> 32)
