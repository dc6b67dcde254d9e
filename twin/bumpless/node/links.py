"""Does this session reach everyone on the bus? Peers find each other one by one, through those they know."""

import json
import time

import zenoh

EVERYONE = "@/*/*"  # each session's account of itself and of whom it is linked with
ANSWER_S = 1.0  # for a session that hangs; one that does not answers within milliseconds
PATIENCE_S = 2.0  # for links that may never come: a server that is not there yet, a frozen peer
ASK_AGAIN_S = 0.02  # a link is announced a moment before questions pass it, so news of it would come early


def wait_for_links(session: zenoh.Session, connects: bool) -> None:
    """Return once every peer that anyone here is linked with has answered this session, or after PATIENCE_S.

    An answer shows more than a link: what its sender had declared before, such as liveliness tokens, has
    arrived too. With `connects` at least one link is waited for. A router is not asked: it passes on what
    others say.
    """
    until = time.monotonic() + PATIENCE_S
    while _missing(session, connects) and time.monotonic() < until:
        time.sleep(ASK_AGAIN_S)


def _missing(session: zenoh.Session, connects: bool) -> bool:
    linked = {str(link.zid): link.whatami for link in session.info.transports()}
    if not linked:
        return connects
    expected = {peer for peer, kind in linked.items() if kind == zenoh.WhatAmI.PEER}
    answered = {str(session.zid())}
    for reply in session.get(EVERYONE, timeout=ANSWER_S):
        if reply.ok is None:
            continue
        answered.add(str(reply.ok.key_expr).split("/")[1])
        expected |= _peers_of(reply.ok.payload.to_bytes())
    return bool(expected - answered)


def _peers_of(account: bytes) -> set[str]:
    """Session ids of the peers that a session says it is linked with; none if it says so in other words."""
    try:
        told = json.loads(account)["sessions"]
        return {one["peer"] for one in told if one["whatami"] == "peer"}
    except (ValueError, TypeError, KeyError):
        return set()
