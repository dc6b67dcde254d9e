"""One numbering from the records to the bus."""

import pytest

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import enums
from bumpless.contract.modes import LOOKS


@pytest.mark.parametrize(
    ("kind", "prefix"),
    [
        (pb.Mode, "MODE_"),
        (pb.MissionPhase, "MISSION_PHASE_"),
        (pb.SolveStatus, "SOLVE_STATUS_"),
        (pb.Severity, "SEVERITY_"),
        (pb.DockingStage, "DOCKING_STAGE_"),
        (pb.WaveOffReason, "WAVE_OFF_REASON_"),
    ],
)
def test_plain_numbers_are_the_contracts(kind, prefix) -> None:
    """Protects: a value that the contract gains, or moves, must not be another one in compiled code."""
    names = {name.removeprefix(prefix): number for name, number in kind.items()}
    assert names.pop("UNSPECIFIED") == 0
    assert {name: getattr(enums, name) for name in names} == names


def test_every_mode_is_listed() -> None:
    """Protects: what is done for each mode is done for all, in the order in which they are numbered."""
    assert enums.MODES == tuple(range(enums.FORWARD, enums.FORWARD + len(pb.Mode.items()) - 1))
    assert set(LOOKS) == set(enums.MODES)
