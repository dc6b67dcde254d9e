"""The WebSocket over which a planner's edits are foreseen."""

import asyncio
import contextlib
from typing import cast

from fastapi import APIRouter, WebSocket, WebSocketDisconnect

from bumpless_server.console import Console

router = APIRouter()


@router.websocket("/ws/foresight")
async def foresight(websocket: WebSocket) -> None:
    """Foresee each text that comes, the newest alone; `foresight.told` has the answers."""
    console = cast(Console, websocket.app.state.console)
    await websocket.accept()
    with contextlib.suppress(WebSocketDisconnect, RuntimeError, OSError, asyncio.CancelledError):
        async with console.foresight.client(websocket.send_text) as client:
            while True:
                client.ask(await websocket.receive_text())
