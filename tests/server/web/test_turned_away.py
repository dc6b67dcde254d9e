"""Who is turned away stands in the audit, and a flood of them neither fills it nor hides what was done."""

from bumpless_server.access.who import Role
from bumpless_server.web.turned_away import LINES, MOST_KINDS, PAUSES_S, VERB, Refused, TurnedAway
from tests.server.access.people import Make, logged_in, staffed
from tests.server.serving import serving
from tests.server.web.test_ledger import audited

ONE = Refused("POST /api/mission/start", 423, "Ada holds control", "Bob", "10.0.0.7")


class Clock:
    """Goes when it is told to."""

    now_s = 0.0

    def __call__(self) -> float:
        return self.now_s


def test_the_first_of_a_kind_is_told_at_once_and_the_others_are_counted() -> None:
    """Protects: one refusal is seen as it happens; a thousand are one number, told ever more rarely."""
    clock = Clock()
    turned = TurnedAway(clock)
    assert [line.times for line in turned.hear(ONE)] == [1]
    assert not any(turned.hear(ONE) for _ in range(1000))
    assert turned.waiting
    clock.now_s = PAUSES_S[0]
    assert [(line.newest, line.times) for line in turned.due()] == [(ONE, 1000)]
    assert not turned.waiting
    told = 0
    for second in range(24 * 3600):
        clock.now_s = PAUSES_S[0] + second
        told += len(turned.hear(ONE))
    assert told <= 25


def test_a_flood_from_everywhere_can_not_fill_the_audit() -> None:
    """Protects the disk and the lines of what was done: bounded by the hour, whoever it is; none is lost."""
    clock = Clock()
    turned = TurnedAway(clock)
    flood, lines = 20_000, []
    for k in range(flood):
        clock.now_s = 3600.0 * k / flood
        lines += turned.hear(ONE._replace(address=f"10.{k % 250}.{k // 250 % 250}.1", author=str(k % 7)))
    assert len(lines) <= LINES
    assert len(turned._kinds) <= MOST_KINDS + 1
    waiting = sum(kind.waiting for kind in turned._kinds.values())
    assert sum(line.times for line in lines) + waiting == flood


def test_who_may_not_is_written_down_with_what_was_asked_and_why(make_settings: Make) -> None:
    """Protects: a refused start, a forged origin and a missing log-in stood nowhere but in a counter."""
    with staffed(make_settings(manage_node=False)) as server:
        with logged_in(server, Role.observer) as olga:
            for _ in range(30):
                assert olga.post("/api/mission/start", json={"name": "docking"}).status_code == 403
            forged = olga.put("/api/parameters", json={}, headers={"origin": "http://evil.example"})
            assert forged.status_code == 403
        assert server.http.get("/api/runs").status_code == 401
        with logged_in(server, Role.operator) as otto, logged_in(server, Role.engineer) as erna:
            erna.post("/api/control/take", json={"reason": "mine"}).raise_for_status()
            assert otto.post("/api/mission/start", json={"name": "docking"}).status_code == 423
        away = [line for line in server.console.audit.entries() if line["verb"] == VERB]
    told = [(line["author"], line["details"]["request"], line["details"]["status"]) for line in away]
    assert told == [
        ("olga", "POST /api/mission/start", 403),
        ("", "PUT /api/parameters", 403),
        ("", "GET /api/runs", 401),
        ("otto", "POST /api/mission/start", 423),
    ]
    assert {line["answer"] for line in away} == {"refused"}
    assert "operator" in away[0]["said"] and "another origin" in away[1]["said"]


def test_what_was_counted_is_told_when_the_server_ends(make_settings: Make) -> None:
    """Protects: a number that only stood in memory."""
    settings = make_settings(manage_node=False)
    with serving(settings) as server:
        for _ in range(5):
            server.http.put("/api/parameters", headers={"origin": "http://evil.example"})
    with serving(settings) as again:
        away = [line for line in audited(again) if line["verb"] == VERB]
    assert [line["details"]["times"] for line in away] == [1, 4]
