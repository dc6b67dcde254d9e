"""One shape for every refusal: {"detail": one sentence, "problems": [...]} and a fitting status."""

from collections.abc import Iterable, Mapping
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from starlette.exceptions import HTTPException

from bumpless.config.problems import Problem, ProblemsError
from bumpless_server.files import BadName
from bumpless_server.live.ask import NoAnswer
from bumpless_server.live.desk import Busy
from bumpless_server.plan.missions import MissionExists


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
    return JSONResponse(content, status, media_type="application/problem+json" if status >= 400 else None)


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
            Problem("", None, None, ".".join(map(str, fault["loc"][1:])), fault.get("input"), fault["msg"])
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

    @app.exception_handler(NoAnswer)
    async def no_answer(_request: Request, error: NoAnswer) -> JSONResponse:
        return answer(503, str(error), accepted=False, reason=str(error))

    @app.exception_handler(Busy)
    async def busy(_request: Request, error: Busy) -> JSONResponse:
        return answer(503, str(error), accepted=False, reason=str(error))
