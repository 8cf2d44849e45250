"""Messages for a process that is slow or stopped, and what holds nobody up."""

from __future__ import annotations

import socket
from collections.abc import Iterator

import pytest

from day6_core.link.local import connection as module
from day6_core.link.local.connection import MOST_WAITING, STALLED_SECONDS, Connection
from day6_core.link.local.handshake import Handshake
from tests.link.clock import Clock

FRAME = bytes(100_000)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    made = Clock()
    monkeypatch.setattr(module, "time", made)
    return made


@pytest.fixture
def pair(clock: Clock) -> Iterator[tuple[Connection, socket.socket, list[Connection]]]:
    """A connection, the other end, and the calls for the session's thread."""
    near, far = socket.socketpair()
    called: list[Connection] = []
    made = Connection(near, Handshake("a", calling=True), called.append)
    yield made, far, called
    made.close()
    far.close()


def drained(far: socket.socket, sender: Connection) -> int:
    """Read all that comes; returns the bytes."""
    far.setblocking(False)
    total = 0
    while True:
        try:
            total += len(far.recv(1 << 20))
        except BlockingIOError:
            if sender.flush():
                try:
                    total += len(far.recv(1 << 20))
                except BlockingIOError:
                    return total


def test_a_stopped_process_costs_a_publisher_a_moment_once_and_bounded_memory(
    pair: tuple[Connection, socket.socket, list[Connection]], clock: Clock
) -> None:
    sender, _, called = pair
    for _ in range(1000):
        sender.offer(FRAME, patiently=True)
    assert sender.waiting <= MOST_WAITING + len(FRAME)
    assert sum(clock.slept) < 2 * STALLED_SECONDS
    assert called == [sender], "the session's thread was told once"


def test_who_does_not_wait_never_sleeps(pair: tuple[Connection, socket.socket, list[Connection]], clock: Clock) -> None:
    sender, far, _ = pair
    for _ in range(1000):
        sender.offer(FRAME)
    assert clock.slept == [] and sender.waiting <= MOST_WAITING
    assert drained(far, sender) % len(FRAME) == 0, "whole messages were dropped"
    assert sender.waiting == 0


def test_a_message_of_any_size_is_sent_where_nothing_waits(
    pair: tuple[Connection, socket.socket, list[Connection]],
) -> None:
    sender, far, _ = pair
    sender.offer(bytes(3 * MOST_WAITING))
    assert drained(far, sender) == 3 * MOST_WAITING


def test_for_a_slow_process_a_patient_publisher_loses_nothing(
    pair: tuple[Connection, socket.socket, list[Connection]], clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    sender, far, _ = pair
    far.setblocking(False)
    taken = 0

    def sleep(seconds: float) -> None:  # the other process takes a little, and the session's thread sends on
        nonlocal taken
        clock.now += seconds
        taken += len(far.recv(1 << 20))
        sender.flush()

    monkeypatch.setattr(clock, "sleep", sleep)
    for _ in range(200):
        sender.offer(FRAME, patiently=True)
    assert taken + drained(far, sender) == 200 * len(FRAME)


def test_announcements_are_never_dropped(pair: tuple[Connection, socket.socket, list[Connection]]) -> None:
    sender, far, _ = pair
    for _ in range(100):
        assert sender.send(FRAME)
    assert drained(far, sender) == 100 * len(FRAME)


def test_a_connection_that_ended_says_so(pair: tuple[Connection, socket.socket, list[Connection]]) -> None:
    sender, far, called = pair
    far.close()
    sender.send(b"lost")
    assert sender.broken and called == [sender] and not sender.send(b"again")
    sender.close()
    assert not sender.send(b"again")


def test_what_a_garbage_collection_sends_in_the_middle_comes_after(
    pair: tuple[Connection, socket.socket, list[Connection]],
) -> None:
    sender, far, _ = pair

    class Nested:
        """In place of the socket: sending something makes something else be sent."""

        def __init__(self, real: socket.socket) -> None:
            self.real, self.again = real, True

        def send(self, data: memoryview) -> int:
            if self.again:
                self.again = False
                sender.send(b"second")
            return self.real.send(data[:3])

        def close(self) -> None:
            self.real.close()

    sender.socket = Nested(sender.socket)  # type: ignore[assignment]
    sender.send(b"first")
    assert far.recv(100) == b"firstsecond"
