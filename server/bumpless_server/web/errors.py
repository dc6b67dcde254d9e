"""One shape for every refusal: {"detail": one sentence, "problems": [...]} and a fitting status."""

import errno
import json
import logging
from collections.abc import Iterable, Mapping
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from starlette.exceptions import HTTPException

from bumpless.config.problems import Problem, ProblemsError
from bumpless_server.access.accounts import AccountsError
from bumpless_server.access.lease import NotHolder
from bumpless_server.access.passwords import WeakPassword
from bumpless_server.files import BadName
from bumpless_server.live.ask import NoAnswer
from bumpless_server.live.desk import Busy
from bumpless_server.plan.charts.store import NoChart, TooManyCharts
from bumpless_server.plan.drafts import TooManyDrafts
from bumpless_server.plan.library import NoMission
from bumpless_server.plan.missions import MissionExists

log = logging.getLogger(__name__)

FULL = (errno.ENOSPC, errno.EDQUOT)


class Refusal(Exception):
    """Answer with this status, sentence and problems."""

    def __init__(
        self, status: int, detail: str, problems: Iterable[Mapping[str, Any]] = (), **more: Any
    ) -> None:
        super().__init__(detail)
        self.status, self.detail, self.problems, self.more = status, detail, list(problems), more


def answer(status: int, detail: str, problems: Iterable[Mapping[str, Any]] = (), **more: Any) -> JSONResponse:
    """A refusal in the one shape that the console reads."""
    content = {"detail": detail, "problems": list(problems), **more}
    return Answer(content, status, media_type="application/problem+json" if status >= 400 else None)


class Answer(JSONResponse):
    """JSON that any text of a request may stand in: half a surrogate pair is told as its escape."""

    def render(self, content: Any) -> bytes:
        text = json.dumps(content, ensure_ascii=False, separators=(",", ":"), default=str)
        return text.encode("utf-8", "backslashreplace")


def _shown(value: Any) -> Any:
    """A value of a request as it may stand in an answer: short, and JSON."""
    if value is None or isinstance(value, bool | int):
        return value
    return str(value)[:200] if isinstance(value, str | float) else repr(value)[:200]


def install(app: FastAPI) -> None:
    """Turn every exception a route may raise into an answer."""

    @app.exception_handler(Refusal)
    async def refusal(_request: Request, error: Refusal) -> JSONResponse:
        return answer(error.status, error.detail, error.problems, **error.more)

    @app.exception_handler(HTTPException)
    async def http(_request: Request, error: HTTPException) -> JSONResponse:
        return answer(error.status_code, str(error.detail))

    @app.exception_handler(RequestValidationError)
    async def invalid(_request: Request, error: RequestValidationError) -> JSONResponse:
        problems = [
            Problem(
                "", None, None, ".".join(map(str, fault["loc"][1:])), _shown(fault.get("input")), fault["msg"]
            )
            for fault in error.errors()
        ]
        return answer(422, "the request is not valid", [problem.as_dict() for problem in problems])

    @app.exception_handler(ProblemsError)
    async def problems(_request: Request, error: ProblemsError) -> JSONResponse:
        count = len(error.problems)
        detail = str(error.problems[0]) if count == 1 else f"{count} problems were found"
        return answer(422, detail, [problem.as_dict() for problem in error.problems])

    @app.exception_handler(BadName)
    async def bad_name(_request: Request, error: BadName) -> JSONResponse:
        return answer(422, str(error), [Problem("", None, None, "name", None, str(error)).as_dict()])

    @app.exception_handler(MissionExists)
    async def exists(_request: Request, error: MissionExists) -> JSONResponse:
        return answer(409, str(error))

    @app.exception_handler(NoChart)
    @app.exception_handler(NoMission)
    async def not_there(_request: Request, error: LookupError) -> JSONResponse:
        return answer(404, str(error))

    @app.exception_handler(TooManyCharts)
    @app.exception_handler(TooManyDrafts)
    async def too_many(_request: Request, error: Exception) -> JSONResponse:
        return answer(409, str(error))

    @app.exception_handler(NoAnswer)
    async def no_answer(_request: Request, error: NoAnswer) -> JSONResponse:
        return answer(503, str(error), accepted=False, reason=str(error))

    @app.exception_handler(NotHolder)
    async def not_holder(_request: Request, error: NotHolder) -> JSONResponse:
        return answer(423, str(error))

    @app.exception_handler(AccountsError)
    async def accounts(_request: Request, error: AccountsError) -> JSONResponse:
        return answer(409, str(error))

    @app.exception_handler(WeakPassword)
    async def weak(_request: Request, error: WeakPassword) -> JSONResponse:
        return answer(422, str(error), [Problem("", None, None, "password", None, str(error)).as_dict()])

    @app.exception_handler(UnicodeError)
    async def no_text(_request: Request, error: UnicodeError) -> JSONResponse:
        return answer(422, "the request holds text that is no Unicode")

    @app.exception_handler(OSError)
    async def disk(_request: Request, error: OSError) -> JSONResponse:
        log.error("a request failed on the disk: %s", error)
        if error.errno in FULL:
            return answer(507, "the disk has no room; nothing was kept")
        return answer(500, f"the disk does not allow it: {error.strerror or 'no reason given'}")

    @app.exception_handler(Exception)
    async def unforeseen(_request: Request, error: Exception) -> JSONResponse:
        return answer(500, "an internal error; the server's log tells more")

    @app.exception_handler(Busy)
    async def busy(_request: Request, error: Busy) -> JSONResponse:
        return answer(503, str(error), accepted=False, reason=str(error))
