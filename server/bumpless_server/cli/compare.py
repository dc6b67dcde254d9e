"""`bumpless compare`: recorded runs beside each other, and a gate for a build."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from bumpless.contract.exits import GATE_FAILED, MISUSED

if TYPE_CHECKING:
    from collections.abc import Callable

    from bumpless.review.compare import Comparison
    from bumpless.review.gate import Verdict
    from bumpless.review.subject import Subject

MARKS = {"better": "+", "worse": "-", "same": "=", "": " "}


def compare(
    logs: Annotated[
        list[Path],
        typer.Argument(help="Two to six MCAP files; the first is what the others are compared with."),
    ],
    gate: Annotated[
        Path | None, typer.Option(help="TOML file of limits; exit code 4 when one is not kept.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
    report: Annotated[
        Path | None, typer.Option(help="HTML file to write: the comparison as one page to send.")
    ] = None,
    align: Annotated[
        str,
        typer.Option(help="Moment that the report lays runs over each other at: start, reverse, hover, end."),
    ] = "start",
) -> None:
    """Compare recorded runs: figures, and differences of mission, parameters and software."""
    from bumpless.review.compare import compare as compared
    from bumpless.review.gate import GateError, judge, read_gate
    from bumpless.review.subject import subject_of
    from bumpless_server.cli.extras import need

    need("log", "mcap")
    try:
        comparison = compared([_named(subject_of, log) for log in logs])
        verdicts = judge(read_gate(gate), comparison) if gate is not None else []
        if report is not None:
            _write(report, logs, align)
    except (GateError, ValueError, OSError) as error:
        typer.echo(f"bumpless compare: {error}", err=True)
        raise typer.Exit(MISUSED) from error
    typer.echo(json_of(comparison, verdicts) if as_json else text_of(comparison, verdicts))
    if not all(verdict.passed for verdict in verdicts):
        raise typer.Exit(GATE_FAILED)


def _named(read: "Callable[[Path], Subject]", log: Path) -> "Subject":
    """What is read of a log; its faults with its name, for there are several."""
    try:
        return read(log)
    except ValueError as error:
        raise ValueError(f"{log}: {error}") from error


def _write(target: Path, logs: list[Path], align: str) -> None:
    from bumpless_server.cli.extras import need

    need("report", "jinja2", "matplotlib")
    from bumpless.config.whole import write_text
    from bumpless.review.compared_report import comparison_report
    from bumpless_server.scene.hull_picture import hull_picture

    write_text(target, comparison_report(logs, align, hull_picture))


def text_of(comparison: "Comparison", verdicts: "list[Verdict]") -> str:
    """For a terminal."""
    ids = [subject.info.id for subject in comparison.subjects]
    lines = [f"{chr(65 + k)}  {name}: {s.outcome.replace('_', ' ') or 'not judged'}" for k, (name, s) in
             enumerate(zip(ids, comparison.subjects, strict=True))]  # fmt: skip
    width = max(len(row.figure.label) for row in comparison.figures)
    lines += ["", " " * width + "".join(f"{chr(65 + k):>14}" for k in range(len(ids)))]
    for row in comparison.figures:
        cells = [
            f"{'–' if value is None else f'{value:.{row.figure.decimals}f}'} {MARKS[change]}"
            for value, change in zip(row.values, row.changes, strict=True)
        ]
        lines.append(
            f"{row.figure.label:<{width}}" + "".join(f"{cell:>14}" for cell in cells) + f" {row.figure.unit}"
        )
    if comparison.settings:
        lines += ["", "What differs:"]
        lines += [f"  {row.kind} {row.name}: {' | '.join(row.values)}" for row in comparison.settings]
    if verdicts:
        lines += ["", "Gate:"]
        lines += [f"  {'kept  ' if v.passed else 'BROKEN'} {v.run}: {v.rule}" for v in verdicts]
    return "\n".join(lines)


def json_of(comparison: "Comparison", verdicts: "list[Verdict]") -> str:
    """For programs."""
    told = {
        "runs": [{"id": s.info.id, "outcome": s.outcome, "reason": s.reason} for s in comparison.subjects],
        "figures": [
            {"key": r.figure.key, "unit": r.figure.unit, "values": r.values, "changes": r.changes}
            for r in comparison.figures
        ],
        "settings": [{"kind": r.kind, "name": r.name, "values": r.values} for r in comparison.settings],
        "gate": [{"run": v.run, "rule": v.rule, "passed": v.passed} for v in verdicts],
    }
    return json.dumps(told, indent=1, ensure_ascii=False)
