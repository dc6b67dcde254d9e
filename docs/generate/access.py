"""Who may do what: the table that the server's guard obeys, as a page."""

from bumpless_server.access.rights import ROWS, Row
from bumpless_server.access.who import Role
from bumpless_server.keys.access import Party, rights
from docs.generate.markdown import NOTE, table

HEAD = """# Who may do what

One table: the guard of the server obeys it, `tests/server/access/test_matrix.py` tries every cell of it, and
this page prints it. Each role may all that the ones before it may. Where nobody logs in (loopback, no account
made), everybody is an engineer. What stands in no row needs an engineer.

- **observer**: sees everything that flies, its runs and its plans
- **operator**: also commands the vehicle and keeps missions, runs and alarms
- **engineer**: also changes parameters, presets, accounts and tokens, and deletes for good

*Control*: refused (423) while somebody else holds control. Pause and abort are not.

"""
BUS = """
## On the bus

With keys (`bumpless keys`) the router takes from each party only what stands here, and its access control is
made from this very table. Without keys everybody who reaches the bus may everything, and the console says so.

"""
PARTIES = (Party("server"), Party("vehicle", "<vehicle>"), Party("observer", "<name>"))
YES, NO = "yes", "–"


def page() -> str:
    """Markdown: one row for each route and socket."""
    rows = [
        (f"`{row.method} {row.path}`", *(_cell(row, role) for role in (None, *Role)), _control(row))
        for row in ROWS
    ]
    told = table(("route", "nobody", *(role.name for role in Role), "control"), rows)
    bus = [
        (f"`{party.common_name}`", right.why, ", ".join(f"`{key}`" for key in right.keys))
        for party in PARTIES
        for right in rights(party)
    ]
    return NOTE + HEAD + told + BUS + table(("party", "may", "keys"), bus)


def _cell(row: Row, role: Role | None) -> str:
    needed = row.right.role
    return YES if needed is None or (role is not None and role >= needed) else NO


def _control(row: Row) -> str:
    return "needed" if row.right.control else ""
