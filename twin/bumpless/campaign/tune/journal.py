"""The search in its folder: an Optuna study in a journal, locked against a second process.

A kill at any moment leaves at worst the beginning of a line and Optuna's own lock; both are cleared away when
the next process, which holds the folder's lock, opens it.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from bumpless.campaign.plain import plain
from bumpless.campaign.prepared import Prepared, digest
from bumpless.campaign.store import WHAT, StoreError, locked
from bumpless.campaign.tune.values import begun, tune_of

if TYPE_CHECKING:
    from optuna import Study

FILE = "study.journal"


@contextmanager
def opened(folder: Path, prepared: Prepared, resume: bool) -> Iterator["Study"]:
    """The study in `folder`, for one process at a time; a new one unless `resume`.

    Raises StoreError when the folder can't be used, or is another search's.
    """
    with locked(folder):
        found = (folder / FILE).exists()
        if found and not resume:
            raise StoreError(f"{folder} holds a search already; go on with --resume, or choose another --out")
        if found:
            _cleared(folder / FILE)
        yield _study(folder, prepared)


def identity_of(prepared: Prepared) -> dict[str, str]:
    """Hashes of all that decides the steps of a search, but not of how many it takes."""
    sought = {key: value for key, value in plain(tune_of(prepared)).items() if key != "trials"}
    return begun(prepared).identity() | {"tune": digest(sought)}


def _study(folder: Path, prepared: Prepared) -> "Study":
    import optuna
    from optuna.storages import JournalStorage
    from optuna.storages.journal import JournalFileBackend

    optuna.logging.set_verbosity(optuna.logging.WARNING)
    name = prepared.campaign.name
    try:
        storage = JournalStorage(JournalFileBackend(str(folder / FILE)))
        others = [s.study_name for s in optuna.get_all_study_summaries(storage) if s.study_name != name]
        study = optuna.create_study(storage=storage, study_name=name, load_if_exists=True)
    except Exception as error:  # whatever a damaged file makes Optuna trip over
        raise StoreError(f"{folder / FILE} cannot be read: {error}; choose another --out") from error
    identity = identity_of(prepared)
    before = study.user_attrs.get("identity", identity)
    what = WHAT | {"tune": "what is searched"}
    changed = [what[key] for key in identity if before.get(key) != identity[key]]
    if others:
        changed = [f"the campaign's name ({', '.join(others)})"]
    if changed:
        said = " and ".join(changed)
        raise StoreError(f"{folder} was searched with something else: {said} changed; choose another --out")
    study.set_user_attr("identity", identity)
    return study


def _cleared(path: Path) -> None:
    """Without the lock of a process that is no more, and without a line it had only begun."""
    for left in path.parent.glob(f"{path.name}.lock*"):
        left.unlink()
    data = path.read_bytes()
    if not data.endswith(b"\n"):
        with path.open("rb+") as file:
            file.truncate(data.rfind(b"\n") + 1)
