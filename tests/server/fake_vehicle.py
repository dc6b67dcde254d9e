"""A vehicle for tests of the server: speaks the contract, flies nothing, and misbehaves when asked to.

Run as a program. It publishes a plausible cycle at 20 Hz, answers every command, writes one line to
`--told` for each message it has put on the bus ("topic sha256 cycle") and leaves when told to.
"""

import argparse
import hashlib
import json
import os
import secrets
import signal
import sys
import threading
import time
from pathlib import Path

import zenoh

from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.parameters import default_parameters, to_message
from bumpless.config.vehicle import load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.session import session_config
from bumpless.telemetry import problem_messages

PERIOD_S = 0.05


class FakeVehicle:
    """The state of one fake vehicle and its session."""

    def __init__(self, session: zenoh.Session, mission_s: float, told: Path | None) -> None:
        self.session, self.mission_s = session, mission_s
        self.vehicle = load_vehicle("ts100")
        self.told = told.open("a") if told else None
        self.stop = threading.Event()
        self.lock = threading.Lock()
        self.cycle = 0
        self.phase = pb.MISSION_PHASE_IDLE
        self.run_id, self.mission, self.text, self.file_name, self.seed = "", None, "", "", 0
        self.elapsed, self.end_reason = 0.0, ""
        self.defaults = to_message(default_parameters(self.vehicle))
        self.active, self.revision = self.defaults, 1
        self.session_id = secrets.token_hex(4)

    def stamp(self) -> pb.Stamp:
        return pb.Stamp(time_ns=time.time_ns(), mission_time_s=self.elapsed, cycle=self.cycle)

    def put(self, topic: str, message) -> None:
        payload = message.SerializeToString()
        key = keys.event(self.vehicle.id) if topic == "event" else keys.telemetry(self.vehicle.id, topic)
        self.session.put(key, payload, encoding=keys.encoding_of(message))
        if self.told:
            name = topic if topic == "event" else f"tlm/{topic}"
            self.told.write(f"{name} {hashlib.sha256(payload).hexdigest()} {self.cycle} {self.run_id}\n")
            self.told.flush()

    def say(self, code: str, text: str) -> None:
        self.put("event", pb.Event(stamp=self.stamp(), severity=pb.SEVERITY_INFO, code=code, text=text))

    def status(self) -> None:
        self.put(
            "mission",
            pb.MissionStatus(
                stamp=self.stamp(),
                phase=self.phase,
                run_id=self.run_id,
                mission_name=self.mission.name if self.mission else "",
                mission_sha256=self.mission.sha256 if self.mission else "",
                duration_s=self.mission_s,
                elapsed_s=self.elapsed,
                seed=self.seed,
                end_reason=self.end_reason,
            ),
        )

    def slow(self) -> None:
        self.status()
        if self.mission:
            plan = pb.Plan(
                stamp=self.stamp(),
                file_name=self.file_name,
                mission_yaml=self.text,
                sha256=self.mission.sha256,
            )
            self.put("plan", plan)
        self.put(
            "parameters",
            pb.ParametersStatus(
                stamp=self.stamp(), active=self.active, defaults=self.defaults, revision=self.revision
            ),
        )
        self.put(
            "description",
            pb.VehicleDescription(
                stamp=self.stamp(),
                vehicle_id=self.vehicle.id,
                vehicle_name=self.vehicle.name,
                vehicle_toml=self.vehicle.text,
                sha256=self.vehicle.sha256,
                control_period_s=PERIOD_S,
                session_id=self.session_id,
            ),
        )
        self.put("health", pb.Health(stamp=self.stamp(), cycles=self.cycle, process_id=os.getpid()))

    def tick(self) -> None:
        """One control cycle, in the order of telemetry.Teller: an end is told after its last cycle."""
        with self.lock:
            self.cycle += 1
            ended = False
            if self.phase == pb.MISSION_PHASE_RUNNING:
                self.elapsed = round(self.elapsed + PERIOD_S, 6)
                ended = self.elapsed >= self.mission_s
            self.put("navigation", pb.Navigation(stamp=self.stamp(), depth_m=2.0))
            self.put("control", pb.Control(stamp=self.stamp()))
            if ended:
                self.phase, self.end_reason = pb.MISSION_PHASE_COMPLETED, "mission completed"
                self.say("mission_completed", self.end_reason)
                self.slow()
            elif self.cycle % 10 == 0:
                self.slow()

    def answer(self, verb: str, payload: bytes) -> pb.CommandReply:
        with self.lock:
            if verb == "start":
                return self.start(pb.StartMission.FromString(payload))
            if verb == "set_parameters":
                self.active, self.revision = pb.Parameters.FromString(payload), self.revision + 1
                self.slow()
                return pb.CommandReply(accepted=True, revision=self.revision)
            if verb == "shutdown":
                self.stop.set()
                return pb.CommandReply(accepted=True)
            phases = {
                "pause": (pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED),
                "resume": (pb.MISSION_PHASE_PAUSED, pb.MISSION_PHASE_RUNNING),
                "abort": (pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_ABORTED),
            }
            before, after = phases[verb]
            if self.phase != before:
                return pb.CommandReply(accepted=False, reason=f"cannot {verb} now")
            self.phase = after
            self.end_reason = "aborted by the operator" if verb == "abort" else ""
            self.slow()
            return pb.CommandReply(accepted=True)

    def start(self, request: pb.StartMission) -> pb.CommandReply:
        if self.phase in (pb.MISSION_PHASE_RUNNING, pb.MISSION_PHASE_PAUSED):
            return pb.CommandReply(accepted=False, reason="a mission is being flown")
        try:
            self.mission = parse_mission(request.mission_yaml, request.file_name, self.vehicle)
        except MissionError as error:
            return pb.CommandReply(reason="not valid", problems=problem_messages(error.problems))
        self.text, self.file_name, self.seed = request.mission_yaml, request.file_name, request.seed
        self.run_id = f"20260101T000000Z-{self.mission.name}-{secrets.token_hex(2)}"
        self.phase, self.elapsed, self.end_reason = pb.MISSION_PHASE_RUNNING, 0.0, ""
        self.slow()
        self.say("mission_started", "off we go")
        return pb.CommandReply(accepted=True, run_id=self.run_id)


def main() -> int:
    """Run until told to stop."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--connect", required=True)
    parser.add_argument("--mission-s", type=float, default=1e9)
    parser.add_argument("--told", type=Path)
    parser.add_argument("--exit", type=int, help="end at once with this code")
    parser.add_argument("--deaf", action="store_true", help="answer no commands")
    options = parser.parse_args()
    if options.exit is not None:
        return options.exit
    config = session_config("peer", (options.connect,))
    config.insert_json5("connect/retry", json.dumps({"period_init_ms": 100, "period_max_ms": 200}))
    with zenoh.open(config) as session:
        fake = FakeVehicle(session, options.mission_s, options.told)
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, lambda *_: fake.stop.set())

        def on_query(query: zenoh.Query) -> None:
            with query:
                verb = str(query.key_expr).rsplit("/", 1)[-1]
                reply = fake.answer(verb, query.payload.to_bytes() if query.payload else b"")
                if query.attachment is not None:
                    reply.id = pb.RequestHeader.FromString(query.attachment.to_bytes()).id
                query.reply(query.key_expr, reply.SerializeToString(), encoding=keys.encoding_of(reply))

        held: list[object] = [session.liveliness().declare_token(keys.alive("ts100"))]
        if not options.deaf:
            held.append(session.declare_queryable(keys.command("ts100", "*"), on_query))
        fake.slow()
        while not fake.stop.wait(PERIOD_S):
            fake.tick()
        del held
    return 0


if __name__ == "__main__":
    sys.exit(main())
