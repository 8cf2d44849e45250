"""Joins the graphs of several processes and machines over Eclipse Zenoh, in rmw_zenoh's wire format.

Without Zenoh, the processes of one machine are joined all the same (`engine`). Importing this costs nothing; the first `join`
imports the engine. Callers check DAY6_LINK=off first. It imports `day6_core.graph` and `day6_core.interfaces` only; rclpy, the
`ros2` commands and the desktop import it.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from day6_core.reason import fault

if TYPE_CHECKING:
    from day6_core.graph import Graph
    from day6_core.link.classroom.part import ClassPart
    from day6_core.link.link import Link
    from day6_core.link.passing import Passing
    from day6_core.link.state import Door, LinkState

__all__ = ["doors_of", "join", "leave", "link_of", "listen_in", "state_of"]

_links: dict[Graph, Link] = {}
_failures: WeakKeyDictionary[Graph, str] = WeakKeyDictionary()
_abandoned: list[Link] = []
_lock = threading.Lock()
_prepared = False
_forked = False


def join(
    graph: Graph,
    *,
    listen: str | Sequence[str] | None = None,
    connect: str | Sequence[str] | None = None,
    one_shot: bool = False,
    never_wait: bool = False,
    secret: str | None = None,
    part: ClassPart | None = None,
) -> Link:
    """Join `graph` to the graphs of this user's other processes on this machine and domain; returns its link.

    Returns when the session is open and all existing nodes and endpoints are announced (milliseconds); connections come
    up in the background, `Link.wait_settled` waits for them. Never raises because there is no network: `Link.problem` then
    gives the reason, and a warning is logged. Every link is closed when the interpreter exits.

    `listen` and `connect` are Zenoh endpoints (`tcp/0.0.0.0:7447`), the only way out of this machine; anything wrong with
    them is reported in `Link.state` and affects nothing else. Other machines must present `secret` there; in a class this
    graph has `part`. `one_shot` is for commands that query and exit: a client of the meeting point that never runs one.
    `never_wait` is for a process with a screen: a message for a process that does not keep up (stopped, in an endless
    loop) is dropped, where `publish` would otherwise block for up to five seconds.
    """
    try:
        return _joined(graph, _names(listen), _names(connect), one_shot, never_wait, secret, part)
    except Exception as error:
        _failures[graph] = fault(error)
        raise


def _joined(
    graph: Graph,
    listen: Sequence[str],
    connect: Sequence[str],
    one_shot: bool,
    never_wait: bool,
    secret: str | None,
    part: ClassPart | None,
) -> Link:
    from day6_core.graph.discovery import discovery_is_off
    from day6_core.language import language_of, said
    from day6_core.link.engine import OTHER_ENGINE, is_local
    from day6_core.link.link import Link
    from day6_core.link.paths import LinkError

    with _lock:
        link = _links.get(graph)
        if link is not None and not link.closed:
            return link
        _prepare()
        link = _links[graph] = Link(
            graph,
            listen=listen,
            connect=connect,
            one_shot=one_shot,
            never_wait=never_wait,
            secret=secret,
            part=part,
        )
        if not (listen or connect) and discovery_is_off(os.environ):
            link.problem = "ROS_AUTOMATIC_DISCOVERY_RANGE is OFF"
            return link
        try:
            if _forked:
                raise LinkError("this process was forked from one that had joined already")
            link.open()
        except LinkError as error:
            link.problem = str(error)
            _warn(f"other processes cannot be seen: {error}")
        else:
            if is_local() and (count := link.state.with_zenoh):
                _warn(said(OTHER_ENGINE, language_of(os.environ)).format(count=count))
        return link


def _warn(text: str) -> None:
    import logging

    logging.getLogger(__name__).warning("%s", text)


def leave(graph: Graph, *, ending: bool = False) -> None:
    """Close the link of `graph`, if it has one: its nodes disappear elsewhere, remote ones disappear here.

    `ending`: this process is about to end, or at least is done with ROS, as a program after `rclpy.shutdown()`.
    """
    with _lock:
        link = _links.pop(graph, None)
    if link is not None:
        link.close(ending=ending)


def state_of(graph: Graph) -> LinkState:
    """Return the state of the link of `graph`; if it has none, only why not, where an error is the reason."""
    from day6_core.link.state import LinkState

    link = _links.get(graph)
    return link.state if link is not None else LinkState(problem=_failures.get(graph))


def listen_in(graph: Graph) -> Passing | None:
    """Return a counter of what other processes send each other, which its caller closes; None without a link."""
    link = _links.get(graph)
    return link.listen_in() if link is not None and not link.closed else None


def link_of(graph: Graph) -> Link | None:
    """Return the link of `graph`, None if it has none."""
    return _links.get(graph)


def doors_of(graph: Graph) -> tuple[Door, ...]:
    """Return the doors this process itself opened for `graph`, from memory."""
    link = _links.get(graph)
    return link.doors if link is not None else ()


def _names(endpoints: str | Sequence[str] | None) -> Sequence[str]:
    if endpoints is None:
        return ()
    return (endpoints,) if isinstance(endpoints, str) else tuple(endpoints)


def _prepare() -> None:
    global _prepared
    if _prepared:
        return
    _prepared = True
    import atexit

    from day6_core.link import fork_hook

    # An open session can keep a process alive for minutes.
    atexit.register(_leave_all)
    fork_hook.install()


def _leave_all() -> None:
    import _signal as signal  # type: ignore[import-not-found]  # not a student's signal.py

    from day6_core.link.meeting import remove_kept_sockets

    # A real ROS process no longer runs Python's handlers here: a second Ctrl-C prints nothing.
    with suppress(ValueError):  # the interpreter is being ended by another thread
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    for graph in list(_links):
        leave(graph, ending=True)
    remove_kept_sockets()


def after_fork() -> None:
    """In the child of a fork: forget the links, which are the parent's."""
    from day6_core.link.meeting import release_copies

    global _lock, _forked
    _lock = threading.Lock()
    _forked = _forked or bool(_links)
    for link in _links.values():
        link.abandon()
    release_copies()
    # Never freed: Zenoh's objects expect threads that stayed in the parent.
    _abandoned.extend(_links.values())
    _links.clear()
