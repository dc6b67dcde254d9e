"""An alarm is seen, or put aside, by who is in control, under the name of who that is."""

from collections.abc import Callable

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.access.who import Role
from bumpless_server.settings import Settings
from tests.server.access.people import logged_in, staffed


def test_only_who_is_in_control_acknowledges_and_shelves(make_settings: Callable[..., Settings]) -> None:
    """Protects from an alarm put away by somebody who looks on, or in the name of somebody else."""
    with (
        staffed(make_settings(manage_node=False)) as server,
        logged_in(server, Role.operator) as otto,
        logged_in(server, Role.engineer) as erna,
        logged_in(server, Role.observer) as olga,
    ):
        server.console.say(pb.SEVERITY_ALARM, "leak", "Water.", {})
        (alarm,) = server.until(server.console.alarms.open)
        assert otto.post("/api/control/ask", json={"reason": ""}).status_code == 200
        for other in (erna, olga):
            for act in ("acknowledge", "shelve"):
                assert other.post(f"/api/alarms/{alarm.id}/{act}", json={}).status_code in (403, 423)
        assert server.console.alarms.open()[0].acknowledged_ns == 0
        assert otto.post(f"/api/alarms/{alarm.id}/shelve", json={"seconds": 60}).status_code == 204
        assert otto.post(f"/api/alarms/{alarm.id}/acknowledge", json={"by": "erna"}).status_code == 204
        (seen,) = server.console.alarms.history()
        assert (seen.acknowledged_by, seen.details["shelved_by"]) == ("otto", "otto")
