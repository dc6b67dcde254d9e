"""The names of the format: records, attachments and states of a run's file."""

from bumpless.contract.names import RUN

LIBRARY = "bumpless"
FORMAT = "2"  # grows when readers must know; 1 named its records "run" and "end"
RUN_RECORD, END_RECORD = "run", "end"
METRICS, PARAMETERS = "metrics.json", "parameters.json"
SEA_FLOOR = "sea_floor.grid"  # the depth grid that the mission named, where whoever flew it had it
YAML, TOML, JSON = "application/yaml", "application/toml", "application/json"
BYTES = "application/octet-stream"
ENDING = ".mcap"

COMPLETE, INTERRUPTED, RECORDING = "complete", "interrupted", "recording"
CUT_OFF = "the recording was cut off"

DESCRIPTION, MISSION, PLAN = "tlm/description", "tlm/mission", "tlm/plan"
PARAMETERS_STATUS = "tlm/parameters"
CONTEXT = (DESCRIPTION, PARAMETERS_STATUS, PLAN)  # what a run's record and attachments are made from
TRUTH, EVENT = "truth/state", "event"


def record_name(kind: str, run: str) -> str:
    """Name of a metadata record of the run with this id, unlike that of any other run."""
    return f"{LIBRARY}.{kind}/{RUN.check(run, 'run id')}"


def record_kind(name: str) -> str:
    """RUN_RECORD or END_RECORD when `name` is a record of ours, of any format; else anything."""
    return name.removeprefix(f"{LIBRARY}.").partition("/")[0]
