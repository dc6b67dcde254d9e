"""A request to the vehicle: who asks, by which id, and what the answer is for a browser."""

import asyncio
from typing import Annotated, Any

from fastapi import Depends, Header, Request
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.names import NameRule
from bumpless_server.live.desk import URGENT, Command
from bumpless_server.live.tally import printable
from bumpless_server.web.answers.contract import CommandReply, told
from bumpless_server.web.errors import Refusal
from bumpless_server.web.known import address_of, who_asks
from bumpless_server.web.routes import Served

REQUEST_ID = NameRule(r"[A-Za-z0-9_-]{1,64}", "1 to 64 of letters, digits, '-' and '_'")
MOST_AUTHOR = 80
_STATUS = {
    pb.REFUSAL_CAUSE_STALE_REVISION: 412,
    pb.REFUSAL_CAUSE_LATE: 503,
    pb.REFUSAL_CAUSE_BUSY: 503,
}


class Commanding:
    """Carries out what one HTTP request asks for.

    `Idempotency-Key` names the request: the same one again is answered, not done again. `If-Match` is the
    revision of the parameters that a change was made from. `X-Operator` is who asks, where nobody logs in.
    """

    def __init__(self, console: Served, request: Request) -> None:
        self._console = console
        self._request = request

    @property
    def author(self) -> str:
        """Who asks: the account, or where nobody logs in, as they say."""
        who = who_asks(self._request)
        if not who.open:
            return who.shown
        return printable(self._request.headers.get("x-operator", ""))[:MOST_AUTHOR]

    async def carry_out(self, verb: str, message: Message, author: str = "", **details: Any) -> CommandReply:
        """Ask the vehicle; a refusal is a 409 with its reason, 412 for a stale revision, 503 when late."""
        who = who_asks(self._request)
        if verb not in URGENT:
            self._console.lease.use(who)
        headers = self._request.headers
        given: dict[str, Any] = {}
        if (key := headers.get("idempotency-key")) is not None:
            given["id"] = REQUEST_ID.check(key, "Idempotency-Key")
        command = Command(
            verb,
            message,
            author=(printable(author)[:MOST_AUTHOR] if who.open else "") or self.author,
            address=address_of(self._request.scope),
            if_revision=_revision(headers.get("if-match")),
            details=details,
            **given,
        )
        reply = await asyncio.wrap_future(self._console.desk.submit(command))
        if reply.accepted and isinstance(message, pb.Parameters):
            self._console.tuned.chosen(message)
        answer = told(reply, CommandReply)
        if not reply.accepted:
            more = answer.model_dump()
            problems = more.pop("problems")
            why = reply.reason or f"the vehicle refuses '{verb}'"
            raise Refusal(_STATUS.get(reply.cause, 409), why, problems, **more)
        return answer


def _revision(header: str | None) -> int | None:
    if header is None or header.strip() == "*":
        return None
    text = header.strip().removeprefix("W/").strip('"')
    if not (text.isascii() and text.isdigit() and len(text) < 19):
        raise Refusal(422, 'If-Match must be a revision of the parameters, such as "7"')
    return int(text)


async def _commanding(
    console: Served,
    request: Request,
    idempotency_key: Annotated[
        str | None, Header(description="Names the request: the same again is answered, not done")
    ] = None,
    if_match: Annotated[
        str | None, Header(description="Revision of the parameters that a change was made from")
    ] = None,
    x_operator: Annotated[str | None, Header(description="Who asks, where nobody logs in")] = None,
) -> Commanding:
    return Commanding(console, request)


Asked = Annotated[Commanding, Depends(_commanding)]
