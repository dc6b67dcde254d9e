"""What stands against a mission, as the API and `bumpless validate --json` tell it."""

from bumpless_server.foresight.told import ForesightFinding
from bumpless_server.web.answers.contract import Answer, Problem


class CheckAnswer(Answer):
    """Problems keep a file from being read; findings tell what of the plan can't work, or may not."""

    file: str
    sha256: str
    ok: bool  # no problem and no hard finding
    problems: list[Problem]
    findings: list[ForesightFinding]
