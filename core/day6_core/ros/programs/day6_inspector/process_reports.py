"""What a Python program tells about its insides (`rclpy._day6.process_report` makes the answer, the link carries it)."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

MOST = 200
"""Nodes, callbacks … of one answer that are read."""

LONGEST_TEXT = 200


class Place(NamedTuple):
    """A line of somebody's program."""

    file: str = ""
    line: int = 0
    text: str = ""

    @property
    def short(self) -> str:
        """`talker.py:12`."""
        return f"{self.file.replace(chr(92), '/').rpartition('/')[2]}:{self.line}" if self.file else "?"


class Inside(NamedTuple):
    """One node as its program sees it."""

    node: str
    spun: bool
    """Whether an executor has ever run its callbacks."""
    spins: bool
    """Whether a thread does so now."""
    late: float
    """Seconds by which its timer that waits longest is overdue."""
    waiting: int
    """Messages and requests that wait for a callback."""
    stands: bool
    """Whether it has timers on simulated time and no time has come yet."""
    publishers: dict[str, int]
    """Topic -> messages published."""
    subscriptions: dict[str, int]
    """Topic -> messages received."""


class Busy(NamedTuple):
    """A callback that runs now."""

    node: str
    what: str
    """The callback's name."""
    seconds: float
    """For how long at least."""
    waits_for: str
    """What it waits in: 'call', 'spin', 'rate', 'service', 'future', 'event', '' for none."""
    place: Place
    waits_on: str = ""
    """The service whose answer it waits for."""
    blocked: str = ""
    """Why that cannot come meanwhile: 'thread' or 'group'; '' if it can, or nobody knows."""
    other: str = ""
    """The callback of the same program that cannot run meanwhile."""


class Standing(NamedTuple):
    """A thread outside callbacks: 'rate' or 'call' while nobody spins, 'service' or 'action' that is not there, 'init'."""

    kind: str
    name: str
    seconds: float
    place: Place


class Hidden(NamedTuple):
    """An exception of a callback that nobody has seen, or one that ended a thread."""

    node: str
    error: str
    place: Place
    thread: str = ""
    """The name of the thread that has ended."""


class Sign(NamedTuple):
    """Something measured inside a program that may be wrong (`rclpy._day6.signs`): `sign_rules` judges it."""

    kind: str
    node: str
    values: dict[str, object]
    place: Place


class ReportedProcess(NamedTuple):
    """One process."""

    zid: str
    pid: int
    arguments: tuple[str, ...]
    nodes: tuple[Inside, ...] = ()
    busy: tuple[Busy, ...] = ()
    standing: tuple[Standing, ...] = ()
    hidden: tuple[Hidden, ...] = ()
    signs: tuple[Sign, ...] = ()

    @property
    def program(self) -> str:
        """The name of the program's file."""
        return self.arguments[0].replace(chr(92), "/").rpartition("/")[2] if self.arguments else "?"


def read_process(zid: str, answer: bytes) -> ReportedProcess | None:
    """Read an answer; None for one that is not as `rclpy._day6.process_report` makes them."""
    try:
        told = json.loads(answer)
        return ReportedProcess(
            zid,
            int(told["pid"]),
            tuple(_text(each) for each in told["arguments"][:MOST]),
            tuple(
                Inside(
                    _text(each["node"]),
                    bool(each["spun"]),
                    bool(each["spins"]),
                    float(each["late"]),
                    int(each["waiting"]),
                    bool(each["stands"]),
                    _counts(each["publishers"]),
                    _counts(each["subscriptions"]),
                )
                for each in told["nodes"][:MOST]
            ),
            tuple(
                Busy(
                    _text(each["node"]),
                    _text(each["what"]),
                    float(each["seconds"]),
                    _text(each["waits_for"]),
                    _place(each),
                    _text(each["waits_on"]),
                    _text(each["blocked"]),
                    _text(each["other"]),
                )
                for each in told["busy"][:MOST]
            ),
            tuple(
                Standing(_text(each["kind"]), _text(each["name"]), float(each["seconds"]), _place(each))
                for each in told["standing"][:MOST]
            ),
            tuple(
                Hidden(_text(each["node"]), _text(each["error"]), _place(each), _text(each["thread"]))
                for each in told["hidden"][:MOST]
            ),
            tuple(
                Sign(_text(each["kind"]), _text(each["node"]), _values(each["values"]), _place(each))
                for each in told["signs"][:MOST]
            ),
        )
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None


def _text(value: object) -> str:
    return str(value)[:LONGEST_TEXT]


def _counts(value: Any) -> dict[str, int]:
    return {_text(topic): int(count) for topic, count in list(value.items())[:MOST]}


def _values(value: Any) -> dict[str, object]:
    return {
        _text(name): each if isinstance(each, (int, float)) else _text(each)
        for name, each in list(value.items())[:MOST]
    }


def _place(value: Any) -> Place:
    return Place(str(value["file"])[:1000], int(value["line"]), _text(value["text"]))
