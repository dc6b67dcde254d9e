"""`bumpless reproduce`: every published number beside ours, on one page."""

import hashlib
import json
import platform
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from bumpless_paper.report import Part


def reproduce(
    out: Annotated[
        Path | None,
        typer.Option(help="Folder for index.html, reproduce.json and the figures' CSV.", file_okay=False),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the numbers as JSON.")] = False,
    only: Annotated[
        list[str] | None, typer.Option(help="Only this part or table, such as table6; may be repeated.")
    ] = None,
) -> None:
    """Reproduce the paper's tables and figures.

    Without --out and --json it prints what each part found.

    Exit codes: 0 done, 1 the folder cannot be written, 2 no such part.
    """
    from bumpless_server.cli.extras import need

    need("paper", "scipy", "distributed")
    from bumpless_paper.report.parts import PARTS, run_part, wanted_parts
    from bumpless_server.cli.progress import Progress

    try:
        names = wanted_parts(only or [])
    except KeyError as error:
        known = ", ".join(PARTS)
        typer.echo(f"bumpless reproduce: no part {error.args[0]!r}; there are {known}", err=True)
        raise typer.Exit(2) from error
    _prepare(out)
    parts: list[Part] = []
    begin = time.perf_counter()
    for k, name in enumerate(names):
        label = f"{k + 1}/{len(names)} {name}"
        with Progress(label) as progress:
            progress.watch_compiler()
            since = time.perf_counter()
            part = run_part(name, progress.update)
        parts.append(part)
        typer.echo(f"{label}: {part.title}, {time.perf_counter() - since:.0f} s", err=True)
    result = as_document(parts, names)
    if out is not None:
        try:
            write_folder(out, parts, result, time.perf_counter() - begin)
        except OSError as error:
            typer.echo(f"{error.filename or out}: {error.strerror or error}", err=True)
            raise typer.Exit(1) from error
        typer.echo(f"wrote {out / 'index.html'}", err=True)
    if as_json:
        typer.echo(json.dumps(result, indent=1, ensure_ascii=False))
    elif out is None:
        for part in parts:
            typer.echo(f"{part.title}\n  {part.text}\n")


def _prepare(out: Path | None) -> None:
    """What cannot be written is said before the study is flown, not after it."""
    if out is None:
        return
    import tempfile

    try:
        out.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=out).close()
    except OSError as error:
        typer.echo(f"{out}: {error.strerror or error}", err=True)
        raise typer.Exit(1) from error


def as_document(parts: "list[Part]", names: list[str]) -> dict[str, Any]:
    """The numbers of all parts and what made them; but for runtimes the same inputs give the same."""
    from bumpless.contract.version import software_version

    return {
        "source": "Gao et al. 2026, J. Mar. Sci. Eng. 14(5) 516, doi:10.3390/jmse14050516",
        "software_version": software_version(),
        "parts": {name: part.as_dict() for name, part in zip(names, parts, strict=True)},
    }


def write_folder(out: Path, parts: "list[Part]", result: dict[str, Any], seconds: float) -> None:
    """index.html, reproduce.json, and one CSV per figure."""
    from bumpless.config.whole import write_text
    from bumpless_paper.report import page_of
    from bumpless_paper.report.csv_text import csv_of
    from bumpless_paper.report.summary import summary_html

    out.mkdir(parents=True, exist_ok=True)
    text = json.dumps(result, indent=1, ensure_ascii=False) + "\n"
    write_text(out / "reproduce.json", text)
    for part in parts:
        for figure in part.figures:
            write_text(out / f"{figure.id}.csv", csv_of(figure))
    made_by = {
        "Bumpless": result["software_version"],
        "Python, NumPy, Numba": _versions(),
        "processor": platform.machine(),
        "made in": f"{seconds:.0f} s",
        "SHA-256 of reproduce.json": hashlib.sha256(text.encode()).hexdigest(),
    }
    for part in parts:
        made_by |= {f"SHA-256 of {name}": digest for name, digest in part.hashes.items()}
    write_text(out / "index.html", page_of(parts, made_by, summary_html(result["parts"])))


def _versions() -> str:
    import numba
    import numpy

    return f"{platform.python_version()}, {numpy.__version__}, {numba.__version__}"
