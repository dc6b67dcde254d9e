"""Scenarios S1 to S6 of the paper and S7 on one plant and one reference set, and variants beside them.

They differ in allocator, switching and fault handling only. The mission files `missions/s1*.yaml` to
`s6*.yaml` are `mission_text` of these and a test holds them equal.
Source: Gao et al. 2026, table 5 and sec. 4.2.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from bumpless.config.mission import Mission, parse_mission
from bumpless.config.parameters import Parameters, default_parameters, with_overrides
from bumpless.config.vehicle import Vehicle
from bumpless_paper.study.gains import STUDY_GAINS

FAULT_TIME_S = 45.0
Overrides = Mapping[str, Mapping[str, Any]]

HARD: Overrides = {
    "bumpless": {
        "ramp": False,
        "integrator_alignment": False,
        "scale_integration": False,
        "integral_at_switch": "rescale",
    }
}


@dataclass(frozen=True)
class Scenario:
    """What one scenario changes of the vehicle's parameters; everything else is shared."""

    name: str
    slug: str
    title: str
    summary: str
    overrides: Overrides
    fault: bool = False
    published: bool = True  # one of the paper's own

    @property
    def file(self) -> str:
        """Name of its mission file."""
        return f"{self.name.lower()}_{self.slug}.yaml"


def merged(*parts: Overrides) -> dict[str, dict[str, Any]]:
    """Overrides laid over each other, later ones on top."""
    out: dict[str, dict[str, Any]] = {}
    for part in parts:
        for section, values in part.items():
            out.setdefault(section, {}).update(values)
    return out


# Shared by all besides the study's gains: a target once seen is remembered for 30 s, and hover ends far
# enough out that a drifting vehicle does not chatter between R and H. The allocator flies the published map,
# alpha = delta: what fins do by themselves in drift steadies the hull.
SHARED: Overrides = merged(
    STUDY_GAINS,
    {
        "supervisor": {"detection_hold_cycles": 300, "range_rh_upper_m": 2.5},
        "guidance": {"flow_drift": 0.0},
    },
)


def _allocator(name: str, **more: Any) -> Overrides:
    return {"allocation": {"allocator": name, **more}}


_ALL = (
    Scenario(
        "S1",
        "pid_direct",
        "S1: PID without allocation",
        "Each PID channel drives its own actuators through a fixed mixer; modes switch hard.",
        merged(_allocator("pid_direct", direct_map="thrust"), HARD),
    ),
    Scenario(
        "S2",
        "wls_pinv",
        "S2: weighted pseudo-inverse",
        "A weighted least-squares pseudo-inverse of the map at rest, clipped; modes switch hard.",
        merged(_allocator("wls"), HARD),
    ),
    Scenario(
        "S3",
        "mdca_hard",
        "S3: constrained allocation, hard switching",
        "The very solver and weights of S4; weights, gains and integrals change in one cycle.",
        merged(_allocator("mdca"), HARD),
    ),
    Scenario(
        "S4",
        "mdca_bumpless",
        "S4: constrained allocation, bumpless switching",
        "The whole method: ramped demand and weights, aligned integrals, projected warm start.",
        merged(_allocator("mdca")),
    ),
    Scenario(
        "S5",
        "fault_nominal",
        "S5: propeller fault, nominal allocation",
        "The main propeller keeps 40 % from 45 s on; the allocator goes on with the nominal map.",
        merged(_allocator("mdca", fault_tolerant=False)),
        fault=True,
    ),
    Scenario(
        "S6",
        "fault_tolerant",
        "S6: propeller fault, fault-tolerant allocation",
        "The same fault; the allocator knows it: degraded map, priced slack, priorities, 2 s blend.",
        merged(_allocator("mdca", fault_tolerant=True)),
        fault=True,
    ),
    Scenario(
        "S7",
        "fault_estimated",
        "S7: propeller fault, found by the autopilot",
        "The same fault, but nobody tells: found and estimated from residuals while flying, then as in S6.",
        merged(_allocator("mdca", fault_tolerant=True, effectiveness="estimated")),
        fault=True,
        published=False,
    ),
)
WHY_NOT = "published guidance: seldom docks"
SCENARIOS: dict[str, Scenario] = {s.name: s for s in _ALL}


def _variant(base: str, name: str, title: str, overrides: Overrides) -> Scenario:
    s = SCENARIOS[base]
    return replace(s, name=name, title=title, overrides=merged(s.overrides, overrides))


def _integral(name: str) -> Overrides:
    return {"bumpless": {"integral_at_switch": name}}


VARIANTS: dict[str, Scenario] = {
    s.name: s
    for s in (
        _variant(
            "S1",
            "S1-rpm",
            "S1, demand straight to shaft speed",
            _allocator("pid_direct", direct_map="shaft_speed"),
        ),
        _variant("S3", "S3-keep", "S3, integral action K_I e_I kept in N", _integral("keep")),
        _variant("S3", "S3-reset", "S3, integrals reset to zero", _integral("reset")),
        replace(SCENARIOS["S7"], name="S7-healthy", title="S7 without the fault", fault=False),
    )
}

# The full table of allocator and ramp: everything else is shared. S1 knows its inflow here; without it S1's
# thrust map lacks a term that every other allocator has.
_IN_FLOW = _allocator("pid_direct", direct_map="thrust_in_flow")
HONEST: dict[str, Scenario] = {
    s.name: s
    for s in (
        _variant("S1", "S1-flow", "PID direct, inflow known, hard", _IN_FLOW),
        replace(
            SCENARIOS["S4"], name="S1-flow-ramp", title="PID direct, inflow known, ramp", overrides=_IN_FLOW
        ),
        replace(SCENARIOS["S2"], name="S2", title="WLS, hard"),
        replace(SCENARIOS["S4"], name="S2-ramp", title="WLS, ramp", overrides=_allocator("wls")),
        replace(SCENARIOS["S3"], name="S3", title="MD-CA, hard (S3)"),
        _variant("S4", "S4-no-ramp", "MD-CA, S4 without its ramp", {"bumpless": {"ramp": False}}),
        replace(SCENARIOS["S4"], name="S4", title="MD-CA, ramp (S4)"),
    )
}

REFERENCE = """\
start:
  position_ned_m: [0, 0, 2.0]
  heading_deg: 0
  speed_mps: 0.7
legs:
  - {to_ned_m: [10, 0, 2.0], speed_mps: 0.7}
  - {to_ned_m: [25, 0, 2.1], speed_mps: 0.7}
target:
  position_ned_m: [26.5, 0, 2.1]
  heading_deg: 0
  standoff_m: 1.5
"""


def mission_text(scenario: Scenario) -> str:
    """The mission file of a scenario, YAML."""
    head = {
        "version": 1,
        "name": scenario.file.removesuffix(".yaml"),
        "title": f"{scenario.title} ({WHY_NOT})",
        "summary": scenario.summary,
        "vehicle": "ts100",
        "duration_s": 72,
        "seed": 1,
    }
    tail: dict[str, Any] = {"parameters": merged(SHARED, scenario.overrides)}
    if scenario.fault:
        fault = {"actuator": "n_p", "at_s": FAULT_TIME_S, "effectiveness": 0.4, "blend_s": 2.0}
        tail = {"faults": [fault], **tail}
    origin = (
        "One of the six scenarios of Gao et al. 2026, table 5:"
        if scenario.published
        else "Beside the six scenarios of Gao et al. 2026, table 5:"
    )
    about = (
        f"# {origin} one plant, one set of references.\n"
        "# Written by bumpless_paper.study.scenarios; a test holds the two equal.\n"
    )
    return f"{about}{_yaml(head)}\n{REFERENCE}\n{_yaml(tail)}"


def _yaml(value: Mapping[str, Any], indent: str = "") -> str:
    """Block style for mappings, JSON (which YAML contains) for everything else."""
    lines = ""
    for key, item in value.items():
        if isinstance(item, Mapping):
            lines += f"{indent}{key}:\n{_yaml(item, indent + '  ')}"
        else:
            lines += f"{indent}{key}: {json.dumps(item, ensure_ascii=False)}\n"
    return lines


def mission_of(scenario: Scenario) -> Mission:
    """The scenario as a checked mission."""
    return parse_mission(mission_text(scenario), scenario.file)


def parameters_of(scenario: Scenario, vehicle: Vehicle, extra: Overrides | None = None) -> Parameters:
    """The vehicle's parameters, then `extra` (a trial or an ablation), then the scenario's own."""
    return with_overrides(default_parameters(vehicle), merged(SHARED, extra or {}, scenario.overrides))
