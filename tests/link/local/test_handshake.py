"""Who is let in: only a process that can read this user's password, and only where it was called."""

from __future__ import annotations

import socket

import pytest

from day6_core.link.local.frames import VERSION, Frame, FrameReader, Kind, Malformed, packed
from day6_core.link.local.handshake import Handshake


def frames_in(data: bytes) -> list[Frame]:
    near, far = socket.socketpair()
    with near, far:
        far.send(data)
        return FrameReader().read(near)


def talk(caller: Handshake, called: Handshake) -> None:
    """Give each what the other says, until both have nothing to say."""
    to_called, to_caller = frames_in(caller.begin()), list[Frame]()
    while to_called or to_caller:
        for frame in to_called:
            to_caller += [each for data in called.take(frame) for each in frames_in(data)]
        to_called = [each for frame in to_caller for data in caller.take(frame) for each in frames_in(data)]
        to_caller = []


def two(
    word: str = "", other_word: str | None = None, port: int = 7, other_port: int = 7
) -> tuple[Handshake, Handshake]:
    called_word = word if other_word is None else other_word
    return (
        Handshake("a", calling=True, password=word, port=port),
        Handshake("b", calling=False, password=called_word, port=other_port),
    )


@pytest.mark.parametrize("word", ["", "password"])
def test_two_processes_of_one_user_let_each_other_in(word: str) -> None:
    caller, called = two(word)
    talk(caller, called)
    assert caller.done and called.done and (caller.zid, called.zid) == ("b", "a")


@pytest.mark.parametrize(
    ("caller", "called"),
    [two("password", "another"), two("password", ""), two("", "password"), two("password", port=7, other_port=8)],
    ids=["another password", "none is asked for", "none is known", "passed on from another port"],
)
def test_anybody_else_is_not(caller: Handshake, called: Handshake) -> None:
    with pytest.raises(Malformed):
        talk(caller, called)
        raise Malformed if not (caller.done and called.done) else AssertionError
    assert not (caller.done and called.done)


def test_a_proof_that_is_sent_back_or_again_is_worth_nothing() -> None:
    caller, called = two("password")
    (hello,) = frames_in(caller.begin())
    answer, proof = (frames_in(data)[0] for data in called.take(hello))
    assert proof.kind == Kind.PROOF
    (own_proof,) = [frames_in(data)[0] for data in caller.take(answer)]
    with pytest.raises(Malformed):
        list(caller.take(own_proof))
    again = Handshake("b", calling=False, password="password", port=7)
    list(again.take(hello))
    with pytest.raises(Malformed):
        list(again.take(own_proof))


@pytest.mark.parametrize(
    "first",
    [
        packed(Kind.TOKEN, 1, b"k", payload=bytes(4)),
        packed(Kind.PROOF, 0, attachment=bytes(32)),
        packed(Kind.HELLO, VERSION + 1, b"a", bytes(16)),
        packed(Kind.HELLO, VERSION, b"", bytes(16)),
        packed(Kind.HELLO, VERSION, b"a" * 33, bytes(16)),
        packed(Kind.HELLO, VERSION, b"a", bytes(15)),
    ],
)
@pytest.mark.parametrize("word", ["", "password"])
def test_whoever_begins_otherwise_is_not_let_in(first: bytes, word: str) -> None:
    called = Handshake("b", calling=False, password=word)
    with pytest.raises(Malformed):
        list(called.take(frames_in(first)[0]))
    assert not called.done


def test_of_two_that_called_each_other_one_connection_is_kept() -> None:
    caller, called = Handshake("a", calling=True), Handshake("b", calling=False, is_welcome=lambda zid: zid != "a")
    with pytest.raises(Malformed):
        talk(caller, called)
