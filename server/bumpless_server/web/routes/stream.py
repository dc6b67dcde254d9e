"""The WebSocket that brings the bus to the browser."""

import asyncio
import contextlib
from typing import cast

from fastapi import APIRouter, WebSocket, WebSocketDisconnect

from bumpless_server.console import Console

router = APIRouter()


@router.websocket("/api/stream")
async def stream(websocket: WebSocket) -> None:
    """Send frames until the browser leaves; what it says is not listened to."""
    console = cast(Console, websocket.app.state.console)
    await websocket.accept()

    async def listen() -> None:
        while (await websocket.receive())["type"] != "websocket.disconnect":
            pass

    tasks = {
        asyncio.create_task(console.stream.serve(websocket.send_bytes)),
        asyncio.create_task(listen()),
    }
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        for task in tasks:
            with contextlib.suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError, OSError):
                await task
