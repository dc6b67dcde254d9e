"""A run for another program, whole or a range of it: which kinds there are, and how each is made."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal, get_args

from bumpless.config.whole import whole
from bumpless.runs.cut import Range, cut

Kind = Literal["mcap", "csv", "parquet", "alog"]
KINDS: tuple[Kind, ...] = get_args(Kind)


def export(source: Path, target: Path, kind: Kind, part: Range, signals: Sequence[str] = ()) -> None:
    """Write it; half a file is never left behind.

    Raises ValueError when `source` is no log, has nothing in that range or no such signal, ExtraMissing for a
    table without the extra `data`, OSError when the disk refuses.
    """
    if signals and kind not in ("csv", "parquet"):
        raise ValueError(f"signals are chosen for tables (csv, parquet), not for {kind}")
    if kind == "mcap":
        cut(source, target, part)
        return
    from bumpless.runs.alog import write_alog
    from bumpless.runs.flight import open_run
    from bumpless.runs.tables import chosen, write_csv, write_parquet

    run = open_run(source)
    with whole(target) as partial:
        if kind == "alog":
            write_alog(run, partial, part)
        else:
            write = write_csv if kind == "csv" else write_parquet
            write(chosen(run, signals, part), partial)
