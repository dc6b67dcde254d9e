"""Results on disk: one Parquet part per chunk of flights, and a manifest that says what they belong to.

    DIR/campaign.json       identity, and the campaign as declared
    DIR/flights/*.parquet   rows by flight number; a part is whole or absent

A part appears under its name only when it is complete, so a kill at any moment loses nothing that was stored
and leaves nothing half written. Only numbers that no part holds are flown again: none counts twice.
"""

import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bumpless.campaign.columns import schema_of
from bumpless.campaign.flight import Row
from bumpless.campaign.plain import plain
from bumpless.campaign.prepared import Prepared
from bumpless.config.whole import whole, write_text

try:
    import fcntl
except ImportError:  # no such locks on this system: then nobody watches for a second writer
    fcntl = None

if TYPE_CHECKING:
    import pyarrow as pa

MANIFEST, PARTS = "campaign.json", "flights"
WHAT = {
    "campaign": "the campaign's declaration",
    "missions": "a mission file",
    "vehicle": "the vehicle file",
    "parameters": "the control parameters",
    "software": "the software",
}


class StoreError(RuntimeError):
    """This folder cannot be used for this campaign; the message says why and what to do."""


class Store:
    """The folder of one campaign's results; `opened` makes one."""

    def __init__(self, folder: Path, prepared: Prepared) -> None:
        self.folder = folder
        self.schema = schema_of(prepared)

    def add(self, rows: Sequence[Row]) -> None:
        """Keep a chunk of flights."""
        import pyarrow as pa
        import pyarrow.parquet as pq

        first, last = rows[0]["number"], rows[-1]["number"]
        path = self.folder / PARTS / f"{first:08d}-{last:08d}.parquet"
        with whole(path) as part:
            pq.write_table(pa.Table.from_pylist(list(rows), self.schema), part)

    def numbers(self) -> set[int]:
        """Flights that are stored. Raises StoreError when one is stored twice."""
        found: list[int] = []
        for part in self._parts():
            found += _read(part, ["number"]).column("number").to_pylist()
        if len(set(found)) < len(found):
            raise StoreError(f"{self.folder / PARTS} holds some flights twice; it was changed by hand")
        return set(found)

    def table(self) -> "pa.Table":
        """All rows by number."""
        import pyarrow as pa

        parts = [_read(part) for part in self._parts()]
        whole = pa.concat_tables(parts) if parts else self.schema.empty_table()
        return whole.sort_by("number")

    def _parts(self) -> list[Path]:
        return sorted((self.folder / PARTS).glob("*.parquet"))


def _read(path: Path, columns: list[str] | None = None) -> "pa.Table":
    import pyarrow.parquet as pq

    try:
        return pq.ParquetFile(path).read(columns)
    except (OSError, ValueError) as error:
        raise StoreError(f"{path} cannot be read: {error}; delete it to fly its flights again") from error


@contextmanager
def opened(folder: Path, prepared: Prepared, resume: bool) -> Iterator[Store]:
    """The store in `folder`, locked against a second writer; a new one unless `resume`.

    Raises StoreError when the folder belongs to another campaign, or holds flights and `resume` is False.
    """
    with locked(folder):
        (folder / PARTS).mkdir(exist_ok=True)
        _check(folder, prepared.identity(), resume)
        for left in (folder / PARTS).glob("*.part"):
            left.unlink()
        _write_manifest(folder, prepared)
        yield Store(folder, prepared)


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Make the folder, and keep every other process out of it until the end.

    Raises StoreError when it can't be written, or another process has it.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        mark = (folder / "lock").open("a")
    except OSError as error:
        raise StoreError(f"{folder} cannot be written: {error.strerror}; choose another --out") from error
    with mark:
        try:
            if fcntl is not None:
                fcntl.flock(mark, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise StoreError(f"{folder} is in use by another process that is running now") from error
        yield


def _check(folder: Path, identity: dict[str, str], resume: bool) -> None:
    try:
        before = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))["identity"]
    except FileNotFoundError:
        if any((folder / PARTS).iterdir()):
            raise StoreError(f"{folder} holds flights but no {MANIFEST}; choose another folder") from None
        return
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise StoreError(f"{folder / MANIFEST} cannot be read; choose another folder") from error
    changed = [words for key, words in WHAT.items() if before.get(key) != identity[key]]
    if changed:
        said = " and ".join((", ".join(changed[:-1]), changed[-1]) if len(changed) > 1 else changed)
        raise StoreError(
            f"{folder} was flown with something else: {said} changed since. "
            "Its flights cannot be mixed with new ones; choose another folder with --out"
        )
    if not resume and any((folder / PARTS).glob("*.parquet")):
        raise StoreError(f"{folder} holds flights of this campaign already; go on with --resume")


def _write_manifest(folder: Path, prepared: Prepared) -> None:
    text = json.dumps(manifest(prepared), indent=1, ensure_ascii=False) + "\n"
    write_text(folder / MANIFEST, text)


def manifest(prepared: Prepared) -> dict[str, Any]:
    """What the flights belong to."""
    return {"identity": prepared.identity(), "campaign": plain(prepared.campaign)}


def missing(done: set[int], numbers: Iterable[int]) -> list[int]:
    """Which of `numbers` still have to be flown, in order."""
    return [number for number in numbers if number not in done]
