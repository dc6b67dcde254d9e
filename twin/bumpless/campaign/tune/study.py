"""The search itself: an Optuna study in a file, trial after trial, each flown by all workers.

Every trial's sampler is seeded by how many trials came before, so a search that was killed and resumed takes
the same steps as one that was not, on any number of workers.
"""

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bumpless.campaign.cluster import cores_of
from bumpless.campaign.declaration import Search, Tune
from bumpless.campaign.draws import bits
from bumpless.campaign.engine import answers, in_chunks
from bumpless.campaign.flight import FlyNumbers, Row
from bumpless.campaign.parameter_path import changes_of, value_at
from bumpless.campaign.plain import plain
from bumpless.campaign.prepared import Prepared, digest
from bumpless.campaign.store import StoreError
from bumpless.campaign.tune.score import Quality, endings, quality_of, score_of

if TYPE_CHECKING:
    from distributed import Client
    from optuna import Study, Trial

FILE = "study.journal"
RACES = 4  # a trial is given up after a part of its flights when the rest can't save it
Progress = Callable[[int, int, str], None]
Fly = Callable[[Prepared, Sequence[int]], list[Row]]


def flier(client: "Client") -> Fly:
    """Flies numbers of a campaign on a cluster; rows in the order of the numbers."""

    def fly(prepared: Prepared, numbers: Sequence[int]) -> list[Row]:
        found = answers(client, FlyNumbers(prepared), dict(enumerate(in_chunks(numbers, cores_of(client)))))
        return sorted((row for _, rows in found for row in rows), key=lambda row: row["number"])

    return fly


def opened(folder: Path, prepared: Prepared, resume: bool) -> "Study":
    """The study in `folder`; a new one unless `resume`. Raises StoreError when it is another's."""
    import optuna
    from optuna.storages import JournalStorage
    from optuna.storages.journal import JournalFileBackend

    optuna.logging.set_verbosity(optuna.logging.WARNING)
    folder.mkdir(parents=True, exist_ok=True)
    found = (folder / FILE).exists()
    if found and not resume:
        raise StoreError(f"{folder} holds a search already; go on with --resume, or choose another --out")
    storage = JournalStorage(JournalFileBackend(str(folder / FILE)))
    study = optuna.create_study(storage=storage, study_name=prepared.campaign.name, load_if_exists=True)
    sought = {key: value for key, value in plain(_tune(prepared)).items() if key != "trials"}
    identity = prepared.identity() | {"tune": digest(sought)}
    before = study.user_attrs.get("identity", identity)
    changed = [key for key in identity if before.get(key) != identity[key]]
    if changed:
        raise StoreError(f"{folder} was searched with another {' and '.join(changed)}; choose another --out")
    study.set_user_attr("identity", identity)
    return study


def search(study: "Study", prepared: Prepared, fly: Fly, progress: Progress | None = None) -> None:
    """Trials until there are as many as declared; the first is of the parameters as they are."""
    from optuna.trial import TrialState

    tune = _tune(prepared)
    for left in study.get_trials(deepcopy=False, states=(TrialState.RUNNING, TrialState.WAITING)):
        study.tell(left.number, state=TrialState.FAIL)
    while (count := len(_finished(study))) < tune.trials:
        study.sampler = _sampler(tune, count)
        if count == 0:
            study.enqueue_trial(present(prepared))
        trial = study.ask()
        asked = {path: _suggested(trial, path, s, prepared) for path, s in tune.search.items()}
        value = _fly_trial(study, trial, prepared, asked, fly)
        study.tell(trial, value, state=None if value is not None else TrialState.PRUNED)
        if progress:
            progress(count + 1, tune.trials, f"best score {study.best_value:.3f}")


def present(prepared: Prepared) -> dict[str, float]:
    """The searched parameters as they are, moved into their bounds where they lie outside."""
    values = {}
    for path, s in _tune(prepared).search.items():
        values[path] = min(max(value_at(prepared.setups[0].parameters, path), s.low), s.high)
    return values


def applied(prepared: Prepared, values: dict[str, float]) -> Prepared:
    """The campaign with these parameters."""
    return prepared.with_parameters(changes_of(prepared.setups[0].parameters, values))


def reference_of(study: "Study") -> Quality | None:
    """The quality of the first trial, by which the others are measured."""
    said = study.user_attrs.get("reference")
    return None if said is None else Quality(**json.loads(said))


def _fly_trial(
    study: "Study", trial: "Trial", prepared: Prepared, values: dict[str, float], fly: Fly
) -> float | None:
    """Score of a trial; None when it was given up."""
    count, changed = prepared.campaign.count, applied(prepared, values)
    best = None if not _scored(study) else study.best_value
    rows: list[Row] = []
    for race in range(RACES):
        part = range(count * race // RACES, count * (race + 1) // RACES)
        rows += fly(changed, part) if part else []
        trial.report(endings(rows) * count / max(1, len(rows)), race)
        if best is not None and race < RACES - 1 and endings(rows) > best:
            return None
    reference = reference_of(study)
    if reference is None:
        reference = quality_of(rows)
        study.set_user_attr("reference", json.dumps(vars(reference)))
    trial.set_user_attr("docked", sum(row["outcome"] == "docked" for row in rows))
    return score_of(rows, _tune(prepared).weights, reference)


def _suggested(trial: "Trial", path: str, s: Search, prepared: Prepared) -> float:
    if isinstance(value_at(prepared.setups[0].parameters, path), int):
        return trial.suggest_int(path, round(s.low), round(s.high), log=s.log)
    return trial.suggest_float(path, s.low, s.high, log=s.log)


def _sampler(tune: Tune, count: int) -> Any:
    from optuna.samplers import TPESampler

    return TPESampler(
        n_startup_trials=max(4, min(20, tune.trials // 4)), seed=bits(tune.seed, count, "sampler") >> 32
    )


def _finished(study: "Study") -> list[Any]:
    from optuna.trial import TrialState

    return study.get_trials(deepcopy=False, states=(TrialState.COMPLETE, TrialState.PRUNED))


def _scored(study: "Study") -> list[Any]:
    from optuna.trial import TrialState

    return study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,))


def _tune(prepared: Prepared) -> Tune:
    assert prepared.campaign.tune is not None, "the campaign declares no search"
    return prepared.campaign.tune
