"""The web application around a console: routes, guard, scene and page."""

import logging
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager

from fastapi import FastAPI
from fastapi.concurrency import run_in_threadpool

from bumpless_server.console import Console
from bumpless_server.scene.scene import Scene
from bumpless_server.settings import Settings
from bumpless_server.web import errors, interface
from bumpless_server.web.auth import Auth, session_cookie
from bumpless_server.web.body_limit import BodyLimit
from bumpless_server.web.guard import Guard
from bumpless_server.web.guesses import Guesses
from bumpless_server.web.ledger import Ledger
from bumpless_server.web.routes import (
    alarms,
    charts,
    compare,
    control,
    declared,
    diagnostics,
    exchange,
    export,
    findings,
    flight,
    foresight,
    help,
    hull,
    imports,
    library,
    missions,
    page,
    parameters,
    people,
    planning,
    refly,
    replay,
    report,
    run_views,
    runs,
    shelf,
    status,
    stream,
    what_if,
)
from bumpless_server.web.turned_away import Doorman

log = logging.getLogger(__name__)

ROUTERS = tuple(
    part.router
    for part in (
        status,
        diagnostics,
        people,
        control,
        alarms,
        missions,
        findings,
        exchange,
        library,
        planning,
        charts,
        parameters,
        declared,
        compare,
        flight,
        replay,
        report,
        export,
        refly,
        hull,
        imports,
        what_if,
        runs,
        run_views,
        shelf,
        stream,
        foresight,
    )
)


def create_app(settings: Settings, console: Console | None = None) -> FastAPI:
    """The application. Its lifespan starts and stops the console; one that runs already stays running."""
    console = console or Console(settings)
    own = not console.started

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        async with AsyncExitStack() as stack:
            if own:
                await run_in_threadpool(console.start)
                stack.push_async_callback(run_in_threadpool, console.stop)
            stack.push_async_callback(doorman.stop)
            stack.push_async_callback(console.foresight.stop)
            stack.push_async_callback(console.what_if.stop)
            if app.state.scene is not None:
                await _start(app.state.scene, stack)
            yield

    app = FastAPI(title="Bumpless", version=console.version, lifespan=lifespan, docs_url=None, redoc_url=None)
    app.state.console = console
    app.state.auth = auth = Auth(settings, console.data.secret(), console.accounts, console.sessions)
    app.state.guesses = guesses = Guesses(console.tally.note)
    app.add_middleware(Ledger, audit=console.audit)
    app.add_middleware(
        BodyLimit, max_bytes=settings.upload_bytes, larger={"/api/runs-import": settings.import_bytes}
    )
    doorman = Doorman(console.audit)
    app.add_middleware(Guard, auth=auth, guesses=guesses, lease=console.lease, turn_away=doorman.turn_away)
    errors.install(app)
    for router in ROUTERS:
        app.include_router(router)
    app.state.scene = None
    if settings.scene != "off":
        light = settings.scene == "light"
        app.state.scene = scene = Scene(
            console.state,
            session_cookie,
            light,
            ghosts=console.ghosts,
            holds=lambda: status.vehicle_station(console),
        )
        app.include_router(scene.router)
    interface.install(app)
    help.mount(app)
    page.mount(app, settings.tiles)
    return app


async def _start(scene: Scene, stack: AsyncExitStack) -> None:
    """A scene that cannot start is no reason to be without a console."""
    try:
        await scene.start()
    except Exception:
        log.exception("the 3-D scene could not be started")
    else:
        stack.push_async_callback(scene.stop)
