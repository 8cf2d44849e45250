"""The Zenoh configurations of the three kinds of session: a process, the meeting point, a one-shot command."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.link.limits import MOST_BYTES, MOST_MACHINES
from day6_core.link.paths import MeetingPlace, password
from day6_core.link.secret import USER

if TYPE_CHECKING:
    import zenoh

_COMMON = {
    "scouting/multicast/enabled": "false",
    "scouting/gossip/enabled": "true",
    # Who meets whom is said at the meeting point only. Peers that told each other too would tell everybody about everybody again
    # with each process that comes: of 100 processes that costs half of all their time.
    "scouting/gossip/target": '{router: ["router", "peer"], peer: ["router"]}',
    # Of two processes that discover each other at once only one connects: with two crossing connections both may be dropped.
    "scouting/gossip/autoconnect_strategy": '{peer: {to_router: "always", to_peer: "greater-zid"}}',
    # Zenoh waits this long for peers before `open` returns; ours connects while the program runs on.
    "scouting/delay": "0",
    "open/return_conditions": "{connect_scouted: false, declares: false}",
    "connect/retry": "{period_init_ms: 50, period_max_ms: 250, period_increase_factor: 2}",
    # Needed by the caches of transient-local publishers.
    "timestamping/enabled": "true",
    "transport/shared_memory/enabled": "false",
    # The queue a burst fills (batches of 64 KiB, allocated when needed), and the microseconds a droppable message waits for
    # room in it: the receiver's interpreter gives Zenoh's thread a turn every 5 ms.
    "transport/link/tx/queue/size/data": "16",
    "transport/link/tx/queue/congestion_control/drop/wait_before_drop": "20000",
}

_OTHER_MACHINES = {
    "transport__link__rx__max_message_size": str(MOST_BYTES),
    "transport__unicast__max_sessions": str(MOST_MACHINES),
    # A machine whose cable was pulled is dropped after this many milliseconds without a keep-alive (four are sent).
    "transport__link__tx__lease": "4000",
    # A machine that rejects us is not retried four times a second forever.
    "connect__retry": "{period_init_ms: 100, period_max_ms: 2000, period_increase_factor: 2}",
}
"""Settings of the sessions that other machines can reach."""


def process_config(place: MeetingPlace, zid: str) -> zenoh.Config:
    """Return the configuration of a process: a peer with its own socket that keeps trying to reach the meeting point."""
    return _config(
        place,
        mode='"peer"',
        id=json.dumps(zid),
        listen__endpoints=json.dumps([place.own_endpoint(zid)]),
        connect__endpoints=json.dumps([place.meeting_endpoint]),
        connect__timeout_ms="-1",
        connect__exit_on_failure="false",
    )


def command_config(place: MeetingPlace, zid: str) -> zenoh.Config:
    """Return the configuration of a one-shot command: a client, whose opening fails if there is no meeting point."""
    return _config(
        place,
        mode='"client"',
        id=json.dumps(zid),
        connect__endpoints=json.dumps([place.meeting_endpoint]),
        connect__timeout_ms="0",
        connect__exit_on_failure="true",
    )


def meeting_config(place: MeetingPlace) -> zenoh.Config:
    """Return the configuration of the meeting point: a router through which the processes find each other."""
    return _config(place, mode='"router"', listen__endpoints=json.dumps([place.meeting_endpoint]))


def outer_config(listen: Sequence[str], connect: Sequence[str], secret: str | None, users: Path) -> zenoh.Config:
    """Return the configuration of a `Bridge`'s outer session: a router that does not know this machine's password.

    If there is a `secret`, it presents it, and requires it of others by the file `users`.
    """
    config = _config(
        None,
        mode='"router"',
        listen__endpoints=json.dumps(list(listen)),
        connect__endpoints=json.dumps(list(connect)),
        connect__timeout_ms="-1",
        connect__exit_on_failure="false",
        **_OTHER_MACHINES,
    )
    if secret is not None:
        _require_password(config, USER, secret, users)
    return config


def inner_config(place: MeetingPlace) -> zenoh.Config:
    """Return the configuration of a `Bridge`'s inner session, connected to the processes of this machine."""
    return _config(
        place,
        mode='"router"',
        listen__endpoints="[]",
        connect__endpoints=json.dumps([place.meeting_endpoint]),
        connect__timeout_ms="-1",
        connect__exit_on_failure="false",
    )


def _config(place: MeetingPlace | None, **settings: str) -> zenoh.Config:
    import zenoh

    config: zenoh.Config = zenoh.Config()
    for name, value in _COMMON.items():
        config.insert_json5(name, value)
    for name, value in settings.items():
        config.insert_json5(name.replace("__", "/"), value)
    if place is not None and place.tcp:
        _require_password(config, "day6", password(place), place.folder / "users")
    return config


def _require_password(config: zenoh.Config, user: str, word: str, users: Path) -> None:
    """Present a password to every peer, and require one of those in the file `users`."""
    config.insert_json5("transport/auth/usrpwd/user", json.dumps(user))
    config.insert_json5("transport/auth/usrpwd/password", json.dumps(word))
    config.insert_json5("transport/auth/usrpwd/dictionary_file", json.dumps(str(users)))
