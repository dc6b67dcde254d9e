"""Who may do what on the web: one table that the guard obeys, the docs print and the tests walk through.

What stands in no row needs an engineer: a forgotten route is closed, and a test names it.
"""

import re
from dataclasses import dataclass
from functools import cache

from bumpless_server.access.who import Role

OPEN = None  # nobody needs to be known
OBSERVER, OPERATOR, ENGINEER = Role.observer, Role.operator, Role.engineer


@dataclass(frozen=True)
class Right:
    """The least role, and whether somebody else's holding of control refuses it."""

    role: Role | None
    control: bool = False


@dataclass(frozen=True)
class Row:
    """One cell of the table: a method ("WS": a WebSocket) of paths, with {name} for any one part."""

    method: str
    path: str
    right: Right


def _rows(role: Role | None, lines: str, control: bool = False) -> list[Row]:
    pairs = (line.split() for line in lines.strip().splitlines())
    return [Row(method, path, Right(role, control)) for method, path in pairs]


# The first row that fits counts.
ROWS: tuple[Row, ...] = (
    *_rows(
        OPEN,
        """
        GET /api/health
        POST /api/login
        """,
    ),
    *_rows(
        OBSERVER,
        """
        GET /api/me
        PUT /api/me/password
        POST /api/logout
        GET /api/control
        GET /api/status
        GET /api/events
        GET /api/vehicle
        GET /api/diagnostics
        GET /api/alarms
        GET /api/missions
        GET /api/missions/{name}
        GET /api/missions/{name}/findings
        GET /api/missions/{name}/export
        GET /api/missions/{name}/history
        GET /api/missions/{name}/history/{version}
        GET /api/missions/{name}/difference
        GET /api/missions/{name}/file
        GET /api/missions/{name}/draft
        POST /api/missions/check
        POST /api/missions/import
        POST /api/missions/export
        GET /api/drafts
        GET /api/mission-bin
        GET /api/mission-templates
        GET /api/planning
        GET /api/planning/{vehicle}
        GET /api/parameters
        GET /api/parameters/revisions
        GET /api/presets
        GET /api/presets/{name}
        GET /api/fields/{kind}
        GET /api/schemas/{kind}
        GET /api/compare
        GET /api/compare/report.html
        GET /api/runs
        GET /api/runs/{run}
        GET /api/runs/{run}/replay
        GET /api/runs/{run}/at
        GET /api/runs/{run}/frames
        GET /api/runs/{run}/report.html
        GET /api/runs/{run}/metrics
        GET /api/runs/{run}/export
        GET /api/runs/{run}/hull
        GET /api/runs-disk
        GET /api/runs/{run}/flight
        GET /api/run-views
        GET /api/foxglove_layout.json
        GET /api/runs/{run}/log.mcap
        GET /api/alarms/limits
        GET /api/vehicle/reach
        GET /api/vehicle/station
        GET /api/charts
        GET /api/charts/tiles
        GET /api/charts/{name}/file
        GET /api/charts/{name}/picture
        GET /api/charts/{name}/shown
        GET /api/bin
        POST /api/scene/camera
        POST /api/scene/ruler
        GET /scene/
        GET /scene/{tab}/
        GET /openapi.json
        WS /api/stream
        WS /ws/foresight
        WS /scene
        WS /scene/{tab}
        """,
    ),
    *_rows(
        OPERATOR,
        """
        GET /api/audit
        GET /api/audit.jsonl
        POST /api/control/ask
        POST /api/control/take
        POST /api/control/hand
        POST /api/control/decline
        POST /api/control/release
        POST /api/mission/pause
        POST /api/mission/abort
        POST /api/missions
        PUT /api/missions/{name}
        DELETE /api/missions/{name}
        POST /api/missions/{name}/rename
        POST /api/missions/{name}/duplicate
        PUT /api/missions/{name}/marks
        PUT /api/missions/{name}/draft
        DELETE /api/missions/{name}/draft
        POST /api/mission-bin/{binned}/restore
        DELETE /api/runs/{run}
        POST /api/runs/{run}/refly
        POST /api/runs-import
        POST /api/what-if
        PUT /api/runs/{run}/words
        PUT /api/run-views/{name}
        DELETE /api/run-views/{name}
        PUT /api/charts/{name}
        PUT /api/charts/{name}/owners
        DELETE /api/charts/{name}
        POST /api/bin/{run}/restore
        """,
    ),
    *_rows(
        OPERATOR,
        """
        POST /api/mission/start
        POST /api/mission/{verb}
        POST /api/alarms/{alarm}/acknowledge
        POST /api/alarms/{alarm}/shelve
        """,
        control=True,
    ),
    *_rows(ENGINEER, "PUT /api/parameters", control=True),
    *_rows(
        ENGINEER,
        """
        PUT /api/presets/{name}
        DELETE /api/presets/{name}
        DELETE /api/bin/{run}
        GET /api/users
        POST /api/users
        PUT /api/users/{name}
        DELETE /api/users/{name}
        GET /api/sessions
        DELETE /api/sessions/{session}
        GET /api/tokens
        POST /api/tokens
        DELETE /api/tokens/{token}
        """,
    ),
)
# The page, its files and the help. What the login page needs is open: it is the same for everybody.
PAGES = re.compile(r"/(?!api(/|$)|ws(/|$)|scene(/|$)|openapi\.json$)")
OPEN_PAGES = re.compile(r"/(login|login\.html|assets/[^/]+|favicon\.svg|theme\.js)")
READING = frozenset({"GET", "HEAD", "OPTIONS"})


@cache
def _patterns() -> tuple[tuple[str, re.Pattern[str], Row], ...]:
    return tuple(
        (row.method, re.compile(re.sub(r"\\{\w+\\}", "[^/]+", re.escape(row.path))), row) for row in ROWS
    )


def row_of(method: str, path: str) -> Row | None:
    """The row for a request; HEAD is GET, "WS" is a WebSocket."""
    method = "GET" if method in ("HEAD", "OPTIONS") else method
    for wanted, pattern, row in _patterns():
        if wanted == method and pattern.fullmatch(path):
            return row
    return None


def right_of(method: str, path: str) -> Right:
    """What a request needs."""
    if row := row_of(method, path):
        return row.right
    if method in READING and OPEN_PAGES.fullmatch(path):
        return Right(OPEN)
    if method in READING and PAGES.match(path):
        return Right(OBSERVER)
    return Right(ENGINEER)
