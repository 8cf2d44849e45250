"""The Zenoh configurations of the three kinds of session: a process, the meeting point, a one-shot command."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from day6_tui.core.link.limits import MOST_BYTES, MOST_MACHINES
from day6_tui.core.link.paths import Place, password
from day6_tui.core.link.secret import USER

if TYPE_CHECKING:
    import zenoh

_COMMON = {
    "scouting/multicast/enabled": "false",
    "scouting/gossip/enabled": "true",
    # Of two processes that hear of each other at once only one calls: of two crossing calls both may be given up.
    "scouting/gossip/autoconnect_strategy": '{peer: {to_router: "always", to_peer: "greater-zid"}}',
    # Zenoh waits this long for others before `open` returns; ours connects while the program goes on.
    "scouting/delay": "0",
    "open/return_conditions": "{connect_scouted: false, declares: false}",
    "connect/retry": "{period_init_ms: 50, period_max_ms: 250, period_increase_factor: 2}",
    # Needed by the caches of transient-local publishers.
    "timestamping/enabled": "true",
    "transport/shared_memory/enabled": "false",
    # What a burst fills (batches of 64 KiB, made when needed), and the microseconds a message that may be dropped waits
    # for room: the receiver's interpreter lets Zenoh's thread in every 5 ms.
    "transport/link/tx/queue/size/data": "16",
    "transport/link/tx/queue/congestion_control/drop/wait_before_drop": "20000",
}

_STRANGERS = {
    "transport__link__rx__max_message_size": str(MOST_BYTES),
    "transport__unicast__max_sessions": str(MOST_MACHINES),
    # A machine whose cable was pulled is forgotten after so many milliseconds without a sign of life (four are sent).
    "transport__link__tx__lease": "4000",
    # Who does not let us in is not asked four times a second for ever.
    "connect__retry": "{period_init_ms: 100, period_max_ms: 2000, period_increase_factor: 2}",
}
"""Of the sessions that other machines reach."""


def process_config(place: Place, zid: str) -> zenoh.Config:
    """Return the configuration of a process: a peer with a socket of its own, which keeps trying the meeting point."""
    return _config(
        place,
        mode='"peer"',
        id=json.dumps(zid),
        listen__endpoints=json.dumps([place.own_endpoint(zid)]),
        connect__endpoints=json.dumps([place.meeting_endpoint]),
        connect__timeout_ms="-1",
        connect__exit_on_failure="false",
    )


def command_config(place: Place, zid: str) -> zenoh.Config:
    """Return the configuration of a one-shot command: a client; opening fails when there is no meeting point."""
    return _config(
        place,
        mode='"client"',
        id=json.dumps(zid),
        connect__endpoints=json.dumps([place.meeting_endpoint]),
        connect__timeout_ms="0",
        connect__exit_on_failure="true",
    )


def meeting_config(place: Place) -> zenoh.Config:
    """Return the configuration of the meeting point: a router that tells the processes of one another."""
    return _config(place, mode='"router"', listen__endpoints=json.dumps([place.meeting_endpoint]))


def outer_config(listen: Sequence[str], connect: Sequence[str], secret: str | None, users: Path) -> zenoh.Config:
    """Return the configuration of the half of a `Bridge` that meets other machines: a router without this machine's password.

    With a `secret` it shows that one, and asks for it by the file `users`.
    """
    config = _config(
        None,
        mode='"router"',
        listen__endpoints=json.dumps(list(listen)),
        connect__endpoints=json.dumps(list(connect)),
        connect__timeout_ms="-1",
        connect__exit_on_failure="false",
        **_STRANGERS,
    )
    if secret is not None:
        _ask_for_password(config, USER, secret, users)
    return config


def inner_config(place: Place) -> zenoh.Config:
    """Return the configuration of the half that meets the processes of this machine."""
    return _config(
        place,
        mode='"router"',
        listen__endpoints="[]",
        connect__endpoints=json.dumps([place.meeting_endpoint]),
        connect__timeout_ms="-1",
        connect__exit_on_failure="false",
    )


def _config(place: Place | None, **settings: str) -> zenoh.Config:
    import zenoh

    config: zenoh.Config = zenoh.Config()
    for name, value in _COMMON.items():
        config.insert_json5(name, value)
    for name, value in settings.items():
        config.insert_json5(name.replace("__", "/"), value)
    if place is not None and place.tcp:
        _ask_for_password(config, "day6", password(place), place.folder / "users")
    return config


def _ask_for_password(config: zenoh.Config, user: str, word: str, users: Path) -> None:
    """Show a password to all that are met, and ask them for one of those in the file `users`."""
    config.insert_json5("transport/auth/usrpwd/user", json.dumps(user))
    config.insert_json5("transport/auth/usrpwd/password", json.dumps(word))
    config.insert_json5("transport/auth/usrpwd/dictionary_file", json.dumps(str(users)))
