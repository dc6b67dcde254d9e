"""The state as the scene may draw it: a message with a number that is none has no place in space."""

from typing import Any

from google.protobuf.message import Message

from bumpless_server.live.intake import non_finite


class Finite:
    """A state whose `latest` keeps to the last message of a topic that is finite throughout."""

    def __init__(self, state: Any) -> None:
        self._state = state
        self._seen: dict[str, Message] = {}
        self._good: dict[str, Message] = {}

    def latest(self, topic: str) -> Message | None:
        """The newest finite message of a topic; each one is looked at once."""
        message = self._state.latest(topic)
        if message is None:
            return None
        if self._seen.get(topic) is not message:
            self._seen[topic] = message
            if not non_finite(message):
                self._good[topic] = message
        return self._good.get(topic)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._state, name)
