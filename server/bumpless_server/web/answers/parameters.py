"""What the vehicle is tuned with, what each number may be, and saved sets."""

from datetime import datetime

from bumpless_server.web.answers.contract import Answer, Parameters


class Range(Answer):
    """What one live-tunable number may be. `count`: 0 for one number, -1 for one per command."""

    path: str
    unit: str
    min: float
    max: float
    label: str
    count: int


class ParametersAnswer(Answer):
    """As the vehicle confirmed it."""

    active: Parameters
    defaults: Parameters
    revision: int
    sha256: str
    ranges: list[Range]


class Preset(Answer):
    """A saved set of parameters."""

    name: str
    modified: datetime
    parameters: Parameters
