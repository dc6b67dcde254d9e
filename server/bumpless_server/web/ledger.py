"""ASGI middleware that writes down what was changed here: by whom, from what to what, and what came of it."""

import json
from typing import Annotated, Any

from fastapi import Depends
from fastapi.concurrency import run_in_threadpool
from starlette.datastructures import Headers
from starlette.requests import HTTPConnection
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from bumpless_server.access.deeds import deed_of
from bumpless_server.audit import Audit
from bumpless_server.web.known import KEY, address_of, author_of, who_asks

DEED = "bumpless.deed"  # in the ASGI scope
MOST_SAID = 300
# Understood, and not done. What names nothing, or what nobody understands, asked for nothing.
REFUSED = frozenset({403, 409, 412, 423, 500, 503, 507})


class Deed:
    """What a request does, as its route finds out; a pair is what it was and what it became."""

    def __init__(self, author: str, **details: object) -> None:
        self.author = author
        self.details: dict[str, object] = details

    def tell(self, **details: object) -> None:
        """Add what it changed."""
        self.details |= details


async def _deed(connection: HTTPConnection) -> Deed:
    return connection.scope.get(DEED) or Deed(author_of(who_asks(connection), connection.headers))


Done = Annotated[Deed, Depends(_deed)]


class Ledger:
    """Stands within the guard, so that who asks is known; the line is on the disk before the answer goes."""

    def __init__(self, app: ASGIApp, audit: Audit) -> None:
        self._app, self._audit = app, audit

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve, and write down what calls for it."""
        found = deed_of(scope["method"], scope["path"]) if scope["type"] == "http" else None
        if found is None:
            await self._app(scope, receive, send)
            return
        verb, names = found
        scope[DEED] = deed = Deed(author_of(scope[KEY], Headers(scope=scope)), **names)
        held: list[Message] = []  # a refusal, until its reason is known

        async def send_noted(message: Message) -> None:
            starts = message["type"] == "http.response.start"
            if starts and message["status"] < 400:
                await self._note(scope, verb, deed)
            elif held or (starts and message["status"] in REFUSED):
                held.append(message)
                if starts or message.get("more_body"):
                    return
                await self._note(scope, verb, deed, _reason(held))
                for one in held:
                    await send(one)
                held.clear()
                return
            await send(message)

        try:
            await self._app(scope, receive, send_noted)
        except Exception as error:
            await self._note(scope, verb, deed, type(error).__name__)
            raise

    async def _note(self, scope: Scope, verb: str, deed: Deed, refused: str | None = None) -> None:
        note = self._audit.note
        await run_in_threadpool(note, verb, deed.author, address_of(scope), deed.details, refused)


def _reason(messages: list[Message]) -> str:
    """The sentence of a refusal."""
    body = b"".join(message.get("body", b"") for message in messages)
    try:
        told: Any = json.loads(body)
    except ValueError:
        return "refused"
    return str(told.get("detail", "refused"))[:MOST_SAID] if isinstance(told, dict) else "refused"
