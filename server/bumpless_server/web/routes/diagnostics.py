"""What the server counted, measured and left out; who asked the vehicle for what."""

from datetime import UTC, datetime

from fastapi import APIRouter, Response
from fastapi.responses import FileResponse
from pydantic import ValidationError

from bumpless_server.live.freshness import freshness
from bumpless_server.live.tally import KINDS
from bumpless_server.web.answers.diagnostics import AuditEntry, Counted, Diagnostics, LeftOut, TopicAge
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)


@router.get("/diagnostics")
def diagnostics(console: Served) -> Diagnostics:
    """Counters by kind, age of each topic, files left out, clock and bus."""
    counts = {count.kind: count for count in console.tally.counts()}
    counted = []
    for kind, meaning in KINDS.items():
        count = counts.get(kind)
        last = datetime.fromtimestamp(count.last_ns * 1e-9, UTC) if count else None
        counted.append(
            Counted(
                kind=kind,
                meaning=meaning,
                count=count.count if count else 0,
                last=last,
                example=count.example if count else "",
            )
        )
    return Diagnostics(
        counted=counted,
        topics=[
            TopicAge(
                topic=one.topic,
                age_s=one.age_s if one.age_s >= 0 else None,
                fresh_for_s=one.fresh_for_s,
                late=one.late,
            )
            for one in freshness(console.state)
        ],
        left_out=[LeftOut(folder=f, name=n, reason=r) for f, n, r in console.left_out()],
        clock_offset_s=console.clock.offset_s,
        vehicle_session=console.speaker.session,
        bus_notice=console.bus.notice,
        audit_trouble=console.audit.trouble,
    )


@router.get("/audit")
def audit(console: Served, limit: int = 200) -> list[AuditEntry]:
    """The last commands, newest first; also those from before a restart."""
    found = []
    for entry in reversed(console.audit.entries()):
        try:
            found.append(AuditEntry.model_validate(entry))
        except ValidationError:  # somebody wrote into the file
            continue
    return found[: max(1, min(limit, 1000))]


@router.get("/audit.jsonl", response_class=Response, responses={200: {"content": {"application/jsonl": {}}}})
def audit_file(console: Served) -> Response:
    """All commands ever, one JSON object a line."""
    if not console.data.audit.is_file():
        raise Refusal(404, "no command was given yet")
    return FileResponse(console.data.audit, media_type="application/jsonl", filename="audit.jsonl")
