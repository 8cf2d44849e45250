"""What goes over a connection: frames of a fixed head, a key, an attachment and a payload.

    length of the payload   kind   number   length of the key   length of the attachment   key   attachment   payload

Little endian. Everything is bytes and text: nothing that is received is ever evaluated.
"""

from __future__ import annotations

import socket
from enum import IntEnum
from struct import Struct
from typing import NamedTuple

VERSION = 1
LONGEST_KEY = 4096
"""Bytes. The longest token has 2048 characters."""
LARGEST = 1 << 30
"""Bytes of one message, as Zenoh's between the processes of one machine."""
SMALL = 64
"""Bytes of payload and attachment that a connection may send before it is let in."""
_HEAD = Struct("<IBQHH")
_ROOM = 1 << 16
"""Bytes that are read at once; more where a frame is larger."""


class Kind(IntEnum):
    """The kinds of frames; `number` is the id of what is declared, asked for or answered."""

    HELLO = 1
    """Key: the session's id; attachment: a nonce; number: VERSION."""
    PROOF = 2
    """Attachment: that the sender knows the password."""
    TOKEN = 3
    SUBSCRIBER = 4
    """Payload: how many kept messages it wants of each publisher (4 bytes)."""
    QUERYABLE = 5
    UNDECLARE = 6
    MESSAGE = 7
    """Number: the subscriber that it is for, 0 for all."""
    QUERY = 8
    REPLY = 9
    LAST_REPLY = 10


_KINDS = frozenset(map(int, Kind))


class Malformed(ValueError):
    """What came over a connection isn't what another process of ours would send."""


class Frame(NamedTuple):
    """One frame that was received."""

    kind: int
    number: int
    key: str
    attachment: bytes
    payload: bytes


def packed(kind: Kind, number: int, key: bytes = b"", attachment: bytes = b"", payload: bytes = b"") -> bytes:
    """Return the bytes of a frame."""
    return b"".join((_HEAD.pack(len(payload), kind, number, len(key), len(attachment)), key, attachment, payload))


class FrameReader:
    """Cuts what a connection receives into frames. It takes no more memory than twice what was sent."""

    def __init__(self) -> None:
        self.is_let_in = False
        """Whether frames may be large."""
        self._buffer = bytearray(_ROOM)
        self._filled = 0

    def read(self, connection: socket.socket) -> list[Frame]:
        """Receive once and return the frames that are complete now.

        Raises:
            EOFError: the other side has closed.
            Malformed: what came is no frame.
            OSError: as `recv` does.
        """
        with memoryview(self._buffer) as room:
            count = connection.recv_into(room[self._filled :])
        if not count:
            raise EOFError
        self._filled += count
        return self._cut()

    def _cut(self) -> list[Frame]:
        frames: list[Frame] = []
        start, needed = 0, _HEAD.size
        with memoryview(self._buffer) as view:
            while self._filled - start >= _HEAD.size:
                needed = self._size(view[start:])
                if self._filled - start < needed:
                    break
                frames.append(_frame(view[start : start + needed]))
                start, needed = start + needed, _HEAD.size
        self._make_room(start, needed)
        return frames

    def _size(self, view: memoryview) -> int:
        """Return the size of the frame that begins here."""
        payload, kind, _, key, attachment = _HEAD.unpack_from(view)
        if kind not in _KINDS or key > LONGEST_KEY or payload > LARGEST:
            raise Malformed(f"kind {kind}, {key} and {payload} bytes")
        if not self.is_let_in and payload + attachment > SMALL:
            raise Malformed(f"{payload} bytes before it was let in")
        return int(_HEAD.size + key + attachment + payload)

    def _make_room(self, start: int, needed: int) -> None:
        """Move what is left to the front of a buffer that is large enough for it, as far as it is known to come."""
        left = self._filled - start
        size = max(_ROOM, min(needed, 2 * self._filled))
        if size > len(self._buffer) or (left == 0 and len(self._buffer) > 64 * _ROOM):
            buffer = bytearray(size)
            buffer[:left] = memoryview(self._buffer)[start : self._filled]
            self._buffer = buffer
        elif start:
            self._buffer[:left] = self._buffer[start : self._filled]
        self._filled = left


def _frame(view: memoryview) -> Frame:
    _, kind, number, key, attachment = _HEAD.unpack_from(view)
    at = _HEAD.size + key
    try:
        text = str(view[_HEAD.size : at], "utf-8")
    except UnicodeDecodeError as error:
        raise Malformed(f"a key: {error.reason}") from None
    return Frame(kind, number, text, bytes(view[at : at + attachment]), bytes(view[at + attachment :]))
