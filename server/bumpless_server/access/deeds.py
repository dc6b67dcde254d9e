"""Which requests the audit writes down, and as what: every one that changes something is in one table.

A test holds this table against the one of rights: a new route is written down, or says here why it is not.
"""

from bumpless_server.access.rights import row_of

_Key = tuple[str, str]  # method and path of a row of rights


def _table(lines: str) -> dict[_Key, str]:
    rows = (line.split(maxsplit=2) for line in lines.strip().splitlines())
    return {(method, path): rest for method, path, rest in rows}


# What the request is called in the audit; the route adds what it changed from and to.
DEEDS = _table(
    """
    POST /api/missions save_mission
    PUT /api/missions/{name} save_mission
    DELETE /api/missions/{name} delete_mission
    POST /api/missions/{name}/rename rename_mission
    POST /api/missions/{name}/duplicate duplicate_mission
    PUT /api/missions/{name}/marks mark_mission
    POST /api/mission-bin/{binned}/restore restore_mission
    PUT /api/presets/{name} save_preset
    DELETE /api/presets/{name} delete_preset
    POST /api/alarms/{alarm}/acknowledge acknowledge_alarm
    POST /api/alarms/{alarm}/shelve shelve_alarm
    PUT /api/charts/{name} save_chart
    PUT /api/charts/{name}/owners own_chart
    DELETE /api/charts/{name} delete_chart
    DELETE /api/runs/{run} throw_away_run
    PUT /api/runs/{run}/words describe_run
    POST /api/runs/{run}/refly refly_run
    POST /api/runs-import import_run
    POST /api/bin/{run}/restore take_back_run
    DELETE /api/bin/{run} delete_run
    PUT /api/run-views/{name} save_run_view
    DELETE /api/run-views/{name} forget_run_view
    """
)

# Written down where the vehicle's answer, the account or the holder of control is known.
ELSEWHERE = _table(
    """
    POST /api/mission/start by the desk, with the vehicle's answer
    POST /api/mission/pause by the desk, with the vehicle's answer
    POST /api/mission/abort by the desk, with the vehicle's answer
    POST /api/mission/{verb} by the desk, with the vehicle's answer
    PUT /api/parameters by the desk, with the vehicle's answer
    POST /api/login at the door
    POST /api/logout at the door
    PUT /api/me/password at the door
    POST /api/users at the door
    PUT /api/users/{name} at the door
    DELETE /api/users/{name} at the door
    DELETE /api/sessions/{session} at the door
    POST /api/tokens at the door
    DELETE /api/tokens/{token} at the door
    POST /api/control/ask with the lease
    POST /api/control/take with the lease
    POST /api/control/hand with the lease
    POST /api/control/decline with the lease
    POST /api/control/release with the lease
    """
)

# Nothing of this changes what others see or fly with.
SILENT = _table(
    """
    POST /api/missions/check answers and keeps nothing
    POST /api/missions/import answers and keeps nothing
    POST /api/missions/export answers and keeps nothing
    POST /api/what-if answers and keeps nothing
    POST /api/scene/camera turns one browser's own view
    POST /api/scene/ruler measures in one browser's own view
    PUT /api/missions/{name}/draft work in progress, kept every other second; saving it is written down
    DELETE /api/missions/{name}/draft work in progress
    """
)


def deed_of(method: str, path: str) -> tuple[str, dict[str, str]] | None:
    """What a request is called in the audit, with the names in its path; None: not written down here."""
    row = row_of(method, path)
    verb = DEEDS.get((row.method, row.path)) if row is not None else None
    if row is None or verb is None:
        return None
    parts = zip(row.path.split("/"), path.split("/"), strict=True)
    return verb, {part.strip("{}"): given for part, given in parts if part.startswith("{")}
