"""A mend is a change that can be made as it is, and that mends."""

import re
from typing import Any

import pytest
import yaml

import bumpless
from bumpless.config.mission import parse_mission
from tests.feasibility.test_findings import CASE, IN_STILL_WATER, with_current


def made(text: str, mend: bumpless.Mend) -> str:
    """The mission file with that change."""
    tree: Any = yaml.safe_load(text)
    *way, last = [int(x) if x.isdigit() else x for x in re.findall(r"[A-Za-z_]+|\d+", mend.path)]
    at = tree
    for step in way:
        at = at.setdefault(step, {}) if isinstance(at, dict) else at[step]
    if mend.value is None:
        del at[last]
    else:
        at[last] = list(mend.value) if isinstance(mend.value, tuple) else mend.value
    return yaml.safe_dump(tree)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (with_current(0.1), "current_not_holdable"),
        (with_current(0.01), "current_hard_to_hold"),
        (CASE.replace("[24.5, 0", "[200, 0").replace("[26, 0", "[201.5, 0"), "too_far"),
        (CASE.replace("duration_s: 180", "duration_s: 40"), "short_of_time"),
        (CASE.replace("[26, 0, 2.3]", "[26, 0, 23]"), "target_depth"),
        (CASE.replace("[26, 0, 2.3]", "[26, 10, 2.3]"), "target_not_on_path"),
        (CASE.replace("speed_mps: 0.7}\ntarget", "speed_mps: 4.5}\ntarget"), "leg_too_fast"),
        (CASE + "end: {hover_hold_s: 100}\n", "long_hover"),
        (CASE, "hover_to_the_end"),
        (IN_STILL_WATER, "current_may_differ"),
        (CASE + "sensors: {detection: {outlier_probability: 0.01}}\n", "false_sights"),
        (CASE + "environment: {beam_attenuation_per_m: 0.96}\n", "seen_too_late"),
    ],
)
def test_every_mend_mends(text, code) -> None:
    """Protects: the button beside a finding: its change leads to a mission without that finding."""
    (finding,) = [one for one in bumpless.check(parse_mission(text, "case.yaml")) if one.code == code]
    assert finding.mends
    for mend in finding.mends:
        after = bumpless.check(parse_mission(made(text, mend), "case.yaml"))
        assert code not in [one.code for one in after], mend
