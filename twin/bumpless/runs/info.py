"""What identifies a run and how it ended, as the metadata records hold it."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, Self

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.version import software_version
from bumpless.runs.names import COMPLETE, FORMAT, INTERRUPTED

LONGEST_NUMBER, LARGEST_NUMBER = 19, 2**63 - 1  # digits and value that a list can hold
LONGEST_S = 1e8  # of a flight: three years
_REASONS = {pb.MISSION_PHASE_COMPLETED: "completed", pb.MISSION_PHASE_ABORTED: "aborted"}


@dataclass(frozen=True)
class RunInfo:
    """The run's record. Hashes are SHA-256 of the mission, vehicle and parameters file in the log."""

    id: str  # of the file; `run_id` with .2, .3 ... when a run was recorded in pieces
    run_id: str
    mission: str = ""
    mission_sha256: str = ""
    vehicle: str = ""
    vehicle_sha256: str = ""
    parameters_sha256: str = ""  # as the vehicle says; "" when it has not said
    seed: int = 0
    started_ns: int = 0  # UNIX time of mission time 0
    software_version: str = ""  # of the vehicle
    session: str = ""  # of the vehicle's node
    recorder_version: str = ""

    @classmethod
    def read(cls, record: Mapping[str, str], otherwise: str) -> Self:
        """From a metadata record; `otherwise` is the id where it tells none."""
        found: dict[str, Any] = {"id": otherwise, "run_id": otherwise}
        found |= {name.name: record[name.name] for name in fields(cls) if name.name in record}
        for name in ("seed", "started_ns"):
            text = str(found.pop(name, ""))
            if text.isascii() and text.isdigit() and len(text) <= LONGEST_NUMBER:
                found[name] = min(int(text), LARGEST_NUMBER)
        return cls(**found)

    def record(self) -> dict[str, str]:
        """As a metadata record."""
        return {"format": FORMAT} | {name: str(value) for name, value in asdict(self).items()}


def elapsed_ns(status: pb.MissionStatus) -> int:
    """Mission time that the vehicle tells, ns; 0 where it is none of a flight, such as NaN."""
    return round(status.elapsed_s * 1e9) if 0.0 <= status.elapsed_s <= LONGEST_S else 0


def run_info(
    run: str,
    status: pb.MissionStatus,
    description: pb.VehicleDescription | None = None,
    parameters: pb.ParametersStatus | None = None,
) -> RunInfo:
    """Identity of the run with the file id `run`, from what its vehicle says."""
    vehicle = description or pb.VehicleDescription()
    return RunInfo(
        id=run,
        run_id=status.run_id,
        mission=status.mission_name,
        mission_sha256=status.mission_sha256,
        vehicle=vehicle.vehicle_id,
        vehicle_sha256=vehicle.sha256,
        parameters_sha256="" if parameters is None else parameters.sha256,
        seed=status.seed,
        started_ns=status.stamp.time_ns - elapsed_ns(status),
        software_version=vehicle.software_version,
        session=vehicle.session_id,
        recorder_version=software_version(),
    )


def ending_of(status: pb.MissionStatus) -> tuple[str, str]:
    """(state, reason) of a run whose vehicle last said `status`."""
    state = COMPLETE if status.phase in _REASONS else INTERRUPTED
    return state, status.end_reason or _REASONS.get(status.phase, "the vehicle is idle")
