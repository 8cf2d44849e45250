"""What a test of the default layer may not do, because it depends on more than this process: an error where it is done.

That is: start a process, open a terminal, sleep, connect to a socket that is not the test's own, ask for a machine's name, or
join the link (noticed from the first test on that finds Zenoh loaded). A test that does has one of the markers in `LAYERS` and is
left to the whole run (`pytest --whole`). Waiting for a condition that a thread of this process brings about (`waiting.until`) is
none of these.
"""

from __future__ import annotations

import ipaddress
import os
import socket
import sys
import threading
import time
import traceback
from collections.abc import Callable
from typing import Any, NoReturn
from weakref import WeakSet

import pytest

LAYERS = {
    "process": "starts processes, talks to others, or waits in real time",
    "person": "plays a person at a real terminal",
    "browser": "opens pages in a real Chromium",
    "timing": "measures time: runs alone",
    "outside": "needs a tool that may be missing",
    "long": "stays in this process, but plays more than the default layer has time for",
}
"""The markers of tests that are not in the default layer, and what such a test does."""

CONFINED = ("long",)
"""Which of them are confined all the same."""

_PROCESSES = (
    "subprocess.Popen",
    "os.fork",
    "os.forkpty",
    "os.posix_spawn",
    "os.exec",
    "os.spawn",
    "os.system",
    "pty.spawn",
)

_test = ""
"""The test that is confined now."""
_elsewhere: frozenset[int] = frozenset()
"""Threads that ran before it: what they do isn't its doing."""
_own: WeakSet[socket.socket] = WeakSet()
_violations: list[str] = []


class NotInOneProcess(RuntimeError):
    """A test of the default layer does what only others may."""


def confined(item: pytest.Item) -> bool:
    """Whether the test has to stay in this process."""
    return not any(item.get_closest_marker(name) for name in LAYERS if name not in CONFINED)


def begin(item: pytest.Item) -> None:
    """Confine a test, if it is in the default layer."""
    global _test, _elsewhere
    _violations.clear()
    _elsewhere = frozenset(each.ident or 0 for each in threading.enumerate() if each is not threading.current_thread())
    _test = item.nodeid if confined(item) else ""
    zenoh = sys.modules.get("zenoh")
    if zenoh is not None and not hasattr(zenoh.open, "__wrapped__"):
        _guard(zenoh, "open", "joins the link")


def end() -> None:
    """Let everything be done again."""
    global _test
    _test = ""


def violations() -> list[str]:
    """Return what the test has done although it may not, with the calls that led there."""
    return list(_violations)


def install() -> None:
    """Watch this process from now on; once."""
    sys.addaudithook(_audit)
    _guard(os, "openpty", "opens a terminal")
    sleep = time.sleep

    def watched(seconds: float) -> None:
        if seconds and _test and threading.current_thread() is threading.main_thread():
            _refuse(f"sleeps for {seconds} s")
        sleep(seconds)

    time.sleep = watched


def _guard(place: Any, name: str, what: str) -> None:
    original: Callable[..., Any] | None = getattr(place, name, None)
    if original is None:
        return  # not on this system

    def guarded(*arguments: Any, **keywords: Any) -> Any:
        if _test and threading.get_ident() not in _elsewhere:
            _refuse(what)
        return original(*arguments, **keywords)

    guarded.__wrapped__ = original  # type: ignore[attr-defined]
    setattr(place, name, guarded)


def _audit(event: str, arguments: tuple[Any, ...]) -> None:
    if event == "socket.bind":  # also what a fixture for several tests binds
        _own.add(arguments[0])
    if not _test or threading.get_ident() in _elsewhere:
        return
    if event in _PROCESSES:
        _refuse(f"starts a process ({event})")
    elif event == "socket.connect" and not _is_own(arguments[1]):
        _refuse(f"connects to {arguments[1]!r}, which is not its own")
    elif event == "socket.getaddrinfo" and _is_name(arguments[0]):
        _refuse(f"asks who {arguments[0]!r} is")


def _is_own(address: object) -> bool:
    return any(each.fileno() >= 0 and each.getsockname() == address for each in list(_own))


def _is_name(host: object) -> bool:
    if host in (None, "", "localhost"):
        return False
    try:
        ipaddress.ip_address(host if isinstance(host, str) else bytes(host).decode())  # type: ignore[call-overload]
    except ValueError:
        return True
    return False


def _refuse(what: str) -> NoReturn:
    calls = "".join(traceback.format_stack(sys._getframe(2))[-8:])
    _violations.append(
        f"{_test} {what}, which a test of the default layer may not: it needs a marker (tests/support/one_process.py)\n{calls}"
    )
    raise NotInOneProcess(f"the test {what}")
