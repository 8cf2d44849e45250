"""The attachment of every message, request and response: sequence number, source timestamp and the sender's GID."""

from __future__ import annotations

from struct import Struct, error
from typing import NamedTuple

_WHOLE = Struct("<qqB16s")
_TIMES = Struct("<qq")
_GID_BYTES = 16


class Attachment(NamedTuple):
    """The three values; `source_timestamp` is in epoch nanoseconds, `gid` has 16 bytes."""

    sequence_number: int
    source_timestamp: int
    gid: bytes


def pack(sequence_number: int, source_timestamp: int, gid: bytes) -> bytes:
    """Return the 33 bytes of Jazzy's and Kilted's rmw_zenoh: int64, int64, length of the GID, GID."""
    return _WHOLE.pack(sequence_number, source_timestamp, _GID_BYTES, gid)


def unpack(data: bytes) -> Attachment:
    """Read an attachment, with or without the length byte (releases after Kilted omit it).

    Raises:
        ValueError: for anything else.
    """
    if len(data) == _WHOLE.size and data[_TIMES.size] == _GID_BYTES:
        sequence_number, source_timestamp, _, gid = _WHOLE.unpack(data)  # nearly all, thousands a second
        return Attachment(sequence_number, source_timestamp, gid)
    try:
        sequence_number, source_timestamp = _TIMES.unpack_from(data)
    except error:
        raise ValueError(f"an attachment of {len(data)} bytes") from None
    gid = data[_TIMES.size :]
    if len(gid) != _GID_BYTES:
        raise ValueError(f"an attachment of {len(data)} bytes")
    return Attachment(sequence_number, source_timestamp, gid)
