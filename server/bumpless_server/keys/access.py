"""Who may do what on which key of the bus: one table, from which the router's access control is made.

A party is known by the common name of its certificate, and by its user name. The router takes from each only
what stands here; what it passes on goes to whoever holds a key of this fleet.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from bumpless.contract import keys

ROLES = ("server", "vehicle", "observer")
NAMED = ("vehicle", "observer")  # roles of which there are many

SAY = ("put",)
HEAR = ("declare_subscriber", "declare_liveliness_subscriber", "liveliness_query")
ANSWER = ("declare_queryable", "reply")
ASK = ("query",)
BE_THERE = ("liveliness_token",)
EVERYTHING = (*SAY, "delete", *HEAR, *ANSWER, *ASK, *BE_THERE)

CACHED = "/@adv/**"  # what Zenoh keeps beside a publisher or a subscriber: its cache, and that it is there


@dataclass(frozen=True)
class Party:
    """Somebody who holds a key: its role, and its name where there are many of its role."""

    role: str
    name: str = ""

    @property
    def common_name(self) -> str:
        """As its certificate says, and its user name: "server", "vehicle.ts100"."""
        return f"{self.role}.{self.name}" if self.name else self.role


@dataclass(frozen=True)
class Right:
    """Something that may be done on some keys; `why` is for people."""

    why: str
    messages: tuple[str, ...]
    keys: tuple[str, ...]


def rights(party: Party) -> tuple[Right, ...]:
    """All that a party may do. A vehicle speaks, answers and is there for itself alone."""
    if party.role == "vehicle":
        return _of_vehicle(party.name)
    told = _said("*")
    hear = Right("hears every vehicle", (*HEAR, *ASK), (*told, *_cached(told), *_presence("*")))
    listens = Right("is seen to listen", BE_THERE, _cached(told))
    if party.role == "observer":
        return hear, listens
    return (
        hear,
        listens,
        Right("commands every vehicle", ASK, (keys.command("*", "*"),)),
        Right("says that a console is there", SAY, (keys.heartbeat("*"),)),
    )


def access_control(parties: Sequence[Party]) -> dict[str, Any]:
    """Zenoh's `access_control` for a router between these parties: what nobody may, is denied."""
    rules: list[dict[str, Any]] = [_rule("passed on", EVERYTHING, "egress", _everywhere())]
    subjects, policies = [], []
    for party in parties:
        known = [{**_rule(f"{party.common_name} {right.why}", right.messages, "ingress", right.keys)}
                 for right in rights(party)]  # fmt: skip
        rules += known
        subjects.append({"id": party.common_name, "cert_common_names": [party.common_name],
                         "usernames": [party.common_name]})  # fmt: skip
        policies.append({"rules": ["passed on", *(rule["id"] for rule in known)],
                         "subjects": [party.common_name]})  # fmt: skip
    return {
        "enabled": True,
        "default_permission": "deny",
        "rules": rules,
        "subjects": subjects,
        "policies": policies,
    }


def _of_vehicle(vehicle: str) -> tuple[Right, ...]:
    own = _said(vehicle)
    return (
        Right("speaks for itself", SAY, (*own, *_cached(own))),
        Right("repeats what it said", ANSWER, _cached(own)),
        Right("answers for itself", ANSWER, (keys.command(vehicle, "*"), keys.schema(vehicle))),
        Right("is there", BE_THERE, (*_presence(vehicle), *_cached(own))),
        Right("hears its console", HEAR, (keys.heartbeat(vehicle),)),
        Right("looks for others of its id", (*HEAR, *ASK), (*_presence(vehicle), keys.schema(vehicle))),
    )


def _said(vehicle: str) -> tuple[str, ...]:
    return keys.telemetry(vehicle, "*"), keys.event(vehicle), keys.truth(vehicle)


def _presence(vehicle: str) -> tuple[str, ...]:
    return keys.alive(vehicle), keys.claim(vehicle, "*", "*")


def _cached(said: Sequence[str]) -> tuple[str, ...]:
    return tuple(key + CACHED for key in said)


def _everywhere() -> tuple[str, ...]:
    return f"{keys.ROOT}/**", *_cached(_said("*"))


def _rule(name: str, messages: Sequence[str], flow: str, expressions: Sequence[str]) -> dict[str, Any]:
    return {
        "id": name,
        "permission": "allow",
        "messages": list(messages),
        "flows": [flow],
        "key_exprs": list(expressions),
    }
