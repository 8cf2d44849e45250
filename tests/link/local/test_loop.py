"""The thread of our engine: what it does in which order, and what it leaves alone."""

from __future__ import annotations

import logging
import socket
from collections.abc import Iterator

import pytest

from day6_core.link.local.loop import Loop
from tests.support.waiting import until


class Ended(Exception):
    """What a task of a test raises."""


@pytest.fixture
def loop() -> Iterator[Loop]:
    made = Loop(lambda: None)
    yield made
    made.do(made.end)
    made.join(10.0)


def test_what_was_handed_over_is_done_before_what_the_others_sent_is_read(loop: Loop) -> None:
    near, far = socket.socketpair()
    done: list[str] = []
    with near, far:
        far.send(b"x")
        loop.watch(near, lambda: done.append(near.recv(1).decode()))
        loop.do(lambda: done.append("first"))
        loop.start()
        assert until(lambda: done == ["first", "x"])
        loop.do(lambda: loop.forget(near))
        loop.do(lambda: done.append("forgotten"))
        assert until(lambda: "forgotten" in done)


def test_a_socket_that_a_task_has_closed_is_not_read(loop: Loop, caplog: pytest.LogCaptureFixture) -> None:
    near, far = socket.socketpair()
    done: list[str] = []

    def close() -> None:
        loop.forget(near)
        near.close()

    with far:
        far.send(b"x")
        loop.watch(near, lambda: done.append("read"))
        loop.do(close)
        loop.do(lambda: loop.later(0.0, lambda: done.append("later")))
        loop.start()
        assert until(lambda: done)
        assert done == ["later"] and caplog.text == ""


def test_a_fault_in_a_task_is_logged_and_the_next_one_done(loop: Loop, caplog: pytest.LogCaptureFixture) -> None:
    done: list[int] = []

    def fail() -> None:
        raise Ended

    with caplog.at_level(logging.ERROR):
        loop.do(fail)
        loop.do(lambda: done.append(1))
        loop.start()
        assert until(lambda: done)
    assert "Ended" in caplog.text
