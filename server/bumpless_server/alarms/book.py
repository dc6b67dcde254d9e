"""The alarms there are and were: unacknowledged, acknowledged, returned, shelved. No clock, no thread.

Source: ISA-18.2, alarm state model: an alarm whose cause has gone stays until it was acknowledged.
"""

import json
import logging
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.data_dir import write_whole

log = logging.getLogger(__name__)

# How urgent each kind is, where its severity alone does not say: 1 critical to 5 for the record.
PRIORITIES = {
    "node_died": 1,
    "node_restarted": 1,
    "not_finite": 1,
    "link_lost": 1,
    "too_deep": 1,
    "saturated": 4,
    "disk": 4,
    "clock_offset": 5,
}
OF_SEVERITY: dict[int, int] = {pb.SEVERITY_ALARM: 2, pb.SEVERITY_WARNING: 3}
KEPT = 500  # alarms that are over, in the history


@dataclass
class Alarm:
    """One alarm; times are UNIX ns at the server, 0 for what has not happened."""

    id: str
    code: str
    severity: int
    text: str
    raised_ns: int
    returned_ns: int = 0
    acknowledged_ns: int = 0
    acknowledged_by: str = ""
    count: int = 1
    shelved_until_ns: int = 0
    details: dict[str, str] = field(default_factory=dict)
    priority: int = 0

    @property
    def over(self) -> bool:
        """Gone and seen."""
        return bool(self.returned_ns and self.acknowledged_ns)

    def message(self) -> pb.Alarm:
        """As the contract's."""
        return pb.Alarm(**asdict(self))


class Book:
    """Alarms by their code: while one of a code is not over, its cause coming again makes no second one."""

    def __init__(self, path: Path | None = None) -> None:
        self._path = path
        self._open: dict[str, Alarm] = {}
        self._history: list[Alarm] = []
        self._number = 0
        if path is not None:
            self._read(path)

    def open(self) -> list[Alarm]:
        """Those not over: most urgent first, then the newest."""
        return sorted(self._open.values(), key=lambda a: (a.priority, -a.severity, -a.raised_ns))

    def history(self) -> list[Alarm]:
        """Those that are over, newest first."""
        return self._history[::-1]

    def raise_(
        self, code: str, severity: int, text: str, now_ns: int, details: Mapping[str, str] | None = None
    ) -> bool:
        """Its cause is there; True when that is news."""
        alarm = self._open.get(code)
        if alarm is not None and not alarm.returned_ns:
            return False
        if alarm is not None:  # came back: to be seen anew
            alarm.count, alarm.returned_ns, alarm.acknowledged_ns = alarm.count + 1, 0, 0
            alarm.text, alarm.severity, alarm.raised_ns = text, severity, now_ns
            alarm.details = dict(details or {})
        else:
            self._number += 1
            name = f"{now_ns // 1_000_000:x}-{self._number}"
            alarm = Alarm(name, code, severity, text, now_ns, details=dict(details or {}))
            self._open[code] = alarm
        alarm.priority = PRIORITIES.get(code) or OF_SEVERITY.get(severity, 5)
        self._save()
        return True

    def return_(self, code: str, now_ns: int) -> bool:
        """Its cause has gone; True when that is news."""
        alarm = self._open.get(code)
        if alarm is None or alarm.returned_ns:
            return False
        alarm.returned_ns = now_ns
        self._settle(alarm)
        return True

    def acknowledge(self, alarm_id: str, by: str, now_ns: int) -> bool:
        """Somebody has seen it. False when there is none of that id."""
        alarm = self._by_id(alarm_id)
        if alarm is None:
            return False
        if not alarm.acknowledged_ns:
            alarm.acknowledged_ns, alarm.acknowledged_by = now_ns, by
        self._settle(alarm)
        return True

    def shelve(self, alarm_id: str, until_ns: int, by: str) -> bool:
        """Keep it out of the way until then. False when there is none of that id."""
        alarm = self._by_id(alarm_id)
        if alarm is None:
            return False
        alarm.shelved_until_ns = until_ns
        alarm.details["shelved_by"] = by
        self._save()
        return True

    def _by_id(self, alarm_id: str) -> Alarm | None:
        return next((alarm for alarm in self._open.values() if alarm.id == alarm_id), None)

    def _settle(self, alarm: Alarm) -> None:
        if alarm.over:
            del self._open[alarm.code]
            self._history = [*self._history, alarm][-KEPT:]
        self._save()

    def _save(self) -> None:
        if self._path is None:
            return
        told = {"open": [asdict(a) for a in self._open.values()], "over": [asdict(a) for a in self._history]}
        try:
            write_whole(self._path, json.dumps(told, indent=1).encode())
        except OSError as error:
            log.warning("the alarms cannot be kept in %s: %s", self._path, error)

    def _read(self, path: Path) -> None:
        names = {item.name for item in fields(Alarm)}
        try:
            told = json.loads(path.read_text(encoding="utf-8"))
            alarms = [
                [Alarm(**{k: v for k, v in entry.items() if k in names}) for entry in told[kind]]
                for kind in ("open", "over")
            ]
        except FileNotFoundError:
            return
        except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
            log.warning("%s cannot be read (%s); alarms begin anew", path, error)
            return
        self._open = {alarm.code: alarm for alarm in alarms[0]}
        self._history = alarms[1]
