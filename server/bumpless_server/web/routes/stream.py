"""The WebSocket that brings the bus to the browser."""

import asyncio
import contextlib
from typing import cast

from fastapi import APIRouter, WebSocket, WebSocketDisconnect

from bumpless_server.console import Console
from bumpless_server.web.known import who_asks

router = APIRouter()


@router.websocket("/api/stream")
async def stream(websocket: WebSocket) -> None:
    """Send frames until the browser leaves; what it says is not listened to."""
    console, who = cast(Console, websocket.app.state.console), who_asks(websocket)
    await websocket.accept()

    async def listen() -> None:
        while (await websocket.receive())["type"] != "websocket.disconnect":
            pass

    tasks = {
        asyncio.create_task(console.stream.serve(websocket.send_bytes)),
        asyncio.create_task(listen()),
    }
    console.lease.joined(who)
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        console.lease.left(who)
        for task in tasks:
            task.cancel()
        for task in tasks:
            with contextlib.suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError, OSError):
                await task
