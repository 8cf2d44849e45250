"""Which engine carries messages between the processes of this machine: Zenoh, or our own one (`day6_core.link.local`).

Ours is used where Zenoh isn't installed, or where DAY6_LINK is `local`. Both offer the link the same names. Only Zenoh reaches
other machines and real ROS 2: `gateway`, `bridge` and `classroom` import it themselves.
"""

from __future__ import annotations

import os
import sys
from functools import cache
from importlib import import_module
from typing import Any

from day6_core.language import Pair, said

LOCAL, LOCAL_TCP = "local", "local-tcp"
"""The values of DAY6_LINK that choose our engine, with Unix sockets or with TCP."""

NEEDS_ZENOH: dict[str, Pair] = {
    "missing": (
        "reaching other machines needs eclipse-zenoh, which isn't installed here: pip install eclipse-zenoh",
        "连接其他电脑需要 eclipse-zenoh，这里没有安装：pip install eclipse-zenoh",
    ),
    "chosen": (
        "reaching other machines needs Zenoh, and DAY6_LINK={value} has chosen day6-tui's own transport",
        "连接其他电脑需要 Zenoh，而 DAY6_LINK={value} 选择了 day6-tui 自带的传输",
    ),
}
"""Why other machines cannot be reached."""

_missing: set[str] = set()
"""Filled once importing Zenoh has failed."""

OTHER_ENGINE: Pair = (
    "{count} of your processes here use Zenoh and this one day6-tui's own transport: they don't see each other",
    "这里有 {count} 个你的进程用 Zenoh，而这个进程用 day6-tui 自带的传输：它们互相看不到",
)


def is_chosen() -> bool:
    """Return whether the user asked for our engine."""
    return os.environ.get("DAY6_LINK") in (LOCAL, LOCAL_TCP)


def is_local() -> bool:
    """Return whether this process uses our engine; imports neither."""
    return is_chosen() or bool(_missing) or not _has_zenoh()


def chosen() -> Any:
    """Return the module of the engine that this process uses."""
    if not is_local():
        try:
            return import_module("zenoh")
        except ImportError:  # installed, but not for this system
            _missing.add("zenoh")
    return import_module("day6_core.link.local")


def engine_of(session: object) -> Any:
    """Return the module of the engine that a session belongs to, whatever the environment says by now; None is no session yet."""
    if session is None:
        return chosen()
    return import_module(
        "day6_core.link.local" if type(session).__module__.startswith("day6_core.link.local") else "zenoh"
    )


def extras_of(session: object) -> Any:
    """Return its module for publishers that keep messages for those who come later."""
    return import_module(f"{engine_of(session).__name__}.ext")


def why_no_zenoh(language: str) -> str | None:
    """Return why other machines cannot be reached, in 'zh' or 'en'; None where there is Zenoh."""
    if not is_local():
        return None
    kind = "chosen" if is_chosen() and not _missing and _has_zenoh() else "missing"
    return said(NEEDS_ZENOH[kind], language).format(value=os.environ.get("DAY6_LINK"))


@cache
def _has_zenoh() -> bool:
    from importlib.machinery import PathFinder  # PathFinder is on sys.meta_path in every process

    return "zenoh" in sys.modules or PathFinder.find_spec("zenoh") is not None
