"""What goes over a connection of our engine, whole and mutilated."""

from __future__ import annotations

import random
import socket
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from day6_core.link.local.frames import LARGEST, LONGEST_KEY, FrameReader, Kind, Malformed, packed
from day6_core.link.local.vocabulary import matches


class Chunks:
    """In place of a socket: what is received comes in pieces of these sizes."""

    def __init__(self, data: bytes, sizes: Iterator[int]) -> None:
        self._data, self._sizes = data, sizes

    def recv_into(self, room: memoryview) -> int:
        piece = self._data[: min(next(self._sizes), len(room))]
        room[: len(piece)] = piece
        self._data = self._data[len(piece) :]
        return len(piece)


def read_all(data: bytes, sizes: Iterator[int]) -> list[tuple[int, int, str, bytes, bytes]]:
    reader, source = FrameReader(), Chunks(data, sizes)
    reader.is_let_in = True
    found: list[tuple[int, int, str, bytes, bytes]] = []
    with pytest.raises(EOFError):
        while True:
            found += map(tuple, reader.read(source))  # type: ignore[arg-type]
    return found


frames = st.tuples(
    st.sampled_from(list(Kind)), st.integers(0, 2**64 - 1), st.text(max_size=50), st.binary(max_size=40), st.binary()
)


@given(st.lists(frames, max_size=8), st.integers(0))
def test_frames_come_out_as_they_went_in_however_they_are_cut(
    these: list[tuple[Kind, int, str, bytes, bytes]], seed: int
) -> None:
    random_ = random.Random(seed)
    data = b"".join(packed(kind, number, key.encode(), *rest) for kind, number, key, *rest in these)
    found = read_all(data, iter(lambda: random_.choice((1, 7, 64, 100_000)), 0))
    assert found == [(int(kind), *rest) for kind, *rest in these]


def test_a_large_frame_among_small_ones_comes_whole() -> None:
    large = bytes(range(256)) * 20_000
    data = packed(Kind.MESSAGE, 0, b"k", b"a", b"1") + packed(Kind.MESSAGE, 0, b"k", b"a", large)
    found = read_all(data + packed(Kind.MESSAGE, 0, b"k", b"a", b"2"), iter(lambda: 200_000, 0))
    assert [each[-1] for each in found] == [b"1", large, b"2"]


def test_a_length_alone_takes_no_memory() -> None:
    reader = FrameReader()
    reader.is_let_in = True
    head = packed(Kind.MESSAGE, 0, payload=b"")
    lying = (LARGEST).to_bytes(4, "little") + head[4:]
    assert reader.read(Chunks(lying + bytes(1000), iter(lambda: 10_000, 0))) == []  # type: ignore[arg-type]
    assert len(reader._buffer) < 1_000_000


@pytest.mark.parametrize(
    "data",
    [
        packed(Kind.TOKEN, 1, b"k")[:4] + b"\xff" + packed(Kind.TOKEN, 1, b"k")[5:],
        packed(Kind.TOKEN, 1, bytes(LONGEST_KEY + 1)),
        packed(Kind.TOKEN, 1, b"\xff"),
        (LARGEST + 1).to_bytes(4, "little") + packed(Kind.MESSAGE, 0)[4:],
    ],
    ids=["an unknown kind", "a long key", "a key that is no text", "a message of more than a gigabyte"],
)
def test_what_no_process_of_ours_would_send_is_malformed(data: bytes) -> None:
    reader = FrameReader()
    reader.is_let_in = True
    with pytest.raises(Malformed):
        reader.read(Chunks(data, iter(lambda: 10_000, 0)))  # type: ignore[arg-type]


def test_before_it_is_let_in_a_connection_may_send_little() -> None:
    with pytest.raises(Malformed):
        FrameReader().read(Chunks(packed(Kind.HELLO, 1, b"abc", bytes(100)), iter(lambda: 1000, 0)))  # type: ignore[arg-type]


def test_random_bytes_are_malformed_or_wait_for_more() -> None:
    random_ = random.Random(4)
    for _ in range(3000):
        reader = FrameReader()
        reader.is_let_in = random_.random() < 0.5
        near, far = socket.socketpair()
        with near, far:
            far.send(random_.randbytes(random_.randint(1, 300)))
            try:
                reader.read(near)
            except Malformed:
                continue
            assert reader._filled <= 300


def test_keys_match_as_far_as_the_link_uses_expressions() -> None:
    assert matches("@day6/0/**", "@day6/0/here/abc") and not matches("@day6/0/**", "@day6/01/here/abc")
    assert matches("@day6/0/insides/*", "@day6/0/insides/abc") and not matches(
        "@day6/0/insides/*", "@day6/0/insides/a/b"
    )
    assert matches("a/b", "a/b") and not matches("a/b", "a/c")
