"""A run as one HTML file to send: everything inside, nothing fetched, and it prints on A4.

Needs the extra `report`.
"""

import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib import resources
from pathlib import Path
from typing import Any

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.extras import imported
from bumpless.contract.modes import LOOKS, MODE_LETTERS
from bumpless.contract.version import software_version
from bumpless.metrics import as_dict
from bumpless.review.figures import FIGURES
from bumpless.review.scene3d import MakeHull, as_json, scene, script, script_hash
from bumpless.runs.open_flight import open_flight
from bumpless.runs.run import Run

_WORDS = {mode: look.name for mode, look in LOOKS.items()}


@dataclass(frozen=True)
class Switch:
    """One line of the switch ledger."""

    time_s: float
    change: str  # "F → R"
    why: str
    unless: str  # what would have kept the mode
    dwelt: str
    step: str  # d_u in the paper's window
    settling: str  # until 15 s after the ramp


def report_of(path: Path | Sequence[Path], make_hull: MakeHull | None = None) -> str:
    """The report of a recorded run. Raises ValueError when the file has no figures; `ExtraMissing`.

    path: its file, or those of its pieces in order.
    make_hull: the vehicle's picture for the replay in 3-D; a plain spindle without.
    """
    imported("jinja2", "report")
    from bumpless.review.drawings import drawings

    run = open_flight([path] if isinstance(path, Path) else path)
    metrics, outcome = run.metrics, run.outcome
    events: list[Any] = [message for topic, message in run.messages() if topic == "event"]
    replay = scene([run], [0.0], make_hull)
    told = as_dict(metrics)
    return rendered(
        "report.html.j2",
        replay,
        info=run.info,
        started=datetime.fromtimestamp(max(0, run.info.started_ns) // 1_000_000_000, UTC),
        outcome=outcome,
        verdict=outcome.sentence,
        gaps=run.columns.gaps,
        good=outcome.ending.value in ("docked", "held"),
        drawings=drawings(run, events),
        switches=list(_switches(metrics, events)),
        alarms=[event for event in events if event.severity >= pb.SEVERITY_WARNING],
        figures=[(figure, figure.of(told)) for key, figure in FIGURES.items() if "." not in key],
        modes=list(_modes(told)),
        proposition=(metrics.increment_violations, metrics.demand_step_violations),
        hashes=_hashes(run),
        settings=_settings(run),
        version=software_version(),
        letters=MODE_LETTERS,
    )


def rendered(template: str, replay: dict[str, Any], **told: Any) -> str:
    """A page of one file out of a template of this folder, the view in 3-D in it."""
    jinja2 = imported("jinja2", "report")
    loader = jinja2.FunctionLoader(_read)
    environment = jinja2.Environment(loader=loader, autoescape=True, trim_blocks=True, lstrip_blocks=True)
    view = {"replay": replay, "replay_json": as_json(replay), "script": script(), "policy": policy()}
    return environment.get_template(template).render(**view, **told)


def policy() -> str:
    """What a report may do, offline as well as served: show itself, and run the one script of ours."""
    return (
        f"default-src 'none'; style-src 'unsafe-inline'; script-src '{script_hash()}'; "
        "base-uri 'none'; form-action 'none'"
    )


def _read(name: str) -> str:
    return (resources.files("bumpless.review") / name).read_text(encoding="utf-8")


def _switches(metrics: pb.Metrics, events: list[Any]) -> Iterator[Switch]:
    told = {round(e.stamp.mission_time_s, 2): e.details for e in events if e.code == "mode_switch"}
    for s in metrics.switches:
        details = next((told[t] for t in told if abs(t - s.time_s) < 0.06), {})
        yield Switch(
            time_s=s.time_s,
            change=f"{MODE_LETTERS[s.from_mode]} → {MODE_LETTERS[s.to_mode]}",
            why=details.get("reason", "not told"),
            unless=details.get("unless", ""),
            dwelt=details.get("dwelt_s", ""),
            step=_known(s.command_step_normalised),
            settling=_known(s.command_step_settling),
        )


def _known(step: float) -> str:
    """Of a switch that fell into a gap nobody knows it."""
    return "not recorded" if math.isnan(step) else f"{step:.4f}"


def _modes(told: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for mode in told.get("modes") or ():
        number = pb.Mode.Value(mode["mode"])
        yield {"letter": MODE_LETTERS[number], "name": _WORDS[number], "key": LOOKS[number].key, **mode}


def _hashes(run: Run) -> list[tuple[str, str]]:
    info = run.info
    return [
        ("run", info.run_id),
        ("mission", f"{info.mission}, SHA-256 {info.mission_sha256}"),
        ("vehicle", f"{info.vehicle}, SHA-256 {info.vehicle_sha256}"),
        ("parameters", f"SHA-256 {info.parameters_sha256}" if info.parameters_sha256 else "not told"),
        ("seed", str(info.seed)),
        ("flown by", info.software_version or "not told"),
        ("recorded by", info.recorder_version or "not told"),
    ]


def _settings(run: Run) -> str:
    from bumpless.config.parameters import as_dict as parameters_dict

    parameters = run.parameters
    return "" if parameters is None else json.dumps(parameters_dict(parameters), indent=1, ensure_ascii=False)
