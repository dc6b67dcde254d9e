"""What the operator tuned the vehicle with: told again to a node that came back from a crash without it."""

import threading

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import FLYING
from bumpless_server.live.sample import Sample
from bumpless_server.live.state import State


class Tuned:
    """Remembers by session: `forgotten` gives what the present session lacks."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._lock = threading.Lock()
        self._chosen: pb.Parameters | None = None
        self._session = ""  # that has them
        state.subscribe(self._heard)

    def chosen(self, parameters: pb.Parameters) -> None:
        """The vehicle has accepted these."""
        with self._lock:
            self._chosen = parameters
            self._session = self._present()

    def present(self) -> pb.Parameters | None:
        """What the operator tuned the present vehicle with; None where that is its defaults."""
        status = self._state.latest("parameters")
        with self._lock:
            chosen = self._chosen
        defaults = status.defaults if isinstance(status, pb.ParametersStatus) else None
        return None if chosen is None or chosen == defaults else chosen

    def forgotten(self) -> pb.Parameters | None:
        """What the node of before was tuned with, when the present one is another; asked once of each."""
        with self._lock:
            present = self._present()
            if self._chosen is None or not present or present == self._session:
                return None
            self._session = present
            return self._chosen

    def _heard(self, sample: Sample) -> None:
        """What a vehicle that flies nothing is tuned with is the operator's own, no mission's."""
        if sample.topic != "tlm/parameters":
            return
        status, mission = self._state.latest("parameters"), self._state.latest("mission")
        flying = isinstance(mission, pb.MissionStatus) and mission.phase in FLYING
        if flying or not isinstance(status, pb.ParametersStatus) or status.revision < 2:
            return
        with self._lock:
            if self._session in ("", self._present()):
                self._chosen, self._session = status.active, self._present()

    def _present(self) -> str:
        description = self._state.latest("description")
        return description.session_id if isinstance(description, pb.VehicleDescription) else ""
