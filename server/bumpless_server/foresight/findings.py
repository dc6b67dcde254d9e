"""What stands against a plan, each with its place in the text and the changes that mend it."""

import bumpless
from bumpless.config.text import BOM
from bumpless.config.yaml_text import YamlText
from bumpless_server.foresight.told import ForesightFinding, ForesightMend


def findings_of(mission: bumpless.Mission, vehicle: bumpless.Vehicle | None = None) -> list[ForesightFinding]:
    """The findings of `bumpless.check`, hard ones first."""
    file = YamlText(mission.text.removeprefix(BOM), mission.source)
    return [told(finding, file) for finding in bumpless.check(mission, vehicle)]


def told(finding: bumpless.Finding, file: YamlText) -> ForesightFinding:
    """One finding; `file` is the text that it is about."""
    line, column = file.place_of(finding.field)
    return ForesightFinding(
        severity=finding.severity,
        code=finding.code,
        path=finding.field,
        line=line,
        column=column,
        reason=finding.text,
        change=finding.change,
        mends=[
            ForesightMend(
                label=mend.words,
                path=mend.path,
                value=list(mend.value) if isinstance(mend.value, tuple) else mend.value,
            )
            for mend in finding.mends
        ],
    )
