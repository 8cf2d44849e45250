"""Serializes messages to CDR and back: XCDR version 1, little endian, 4-byte header, as rmw_fastrtps and rmw_zenoh do.

The code for each class is generated on first use by `cdr_write` and `cdr_read`. Alignment is relative to the end of the header.
"""

from __future__ import annotations

import struct

from day6_core.interfaces.cdr_read import DeserializationError, build_reader
from day6_core.interfaces.cdr_write import SerializationError, build_writer
from day6_core.interfaces.registry import message_class, type_name

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

HEADER = b"\x00\x01\x00\x00"
_LITTLE_ENDIAN = 1

__all__ = ["DeserializationError", "SerializationError", "deserialize", "serialize"]


class _Writers(dict[type, "Callable[[bytearray, Any], None]"]):
    """The generated writers by class; missing ones are generated."""

    def __missing__(self, cls: Any) -> Callable[[bytearray, Any], None]:
        self[cls] = writer = build_writer(message_class(cls), self)
        return writer


class _Readers(dict[type, "Callable[[bytes, int, int], tuple[Any, int]]"]):
    """The generated readers by class; missing ones are generated."""

    def __missing__(self, cls: Any) -> Callable[[bytes, int, int], tuple[Any, int]]:
        self[cls] = reader = build_reader(message_class(cls), self)
        return reader


_writers = _Writers()
_readers = _Readers()


def serialize(message: Any) -> bytes:
    """Return a message's CDR bytes with header (rclpy.serialization.serialize_message).

    Raises:
        SerializationError: a value does not fit its field (possible with checks off, or inside lists).
        TypeError: `message` is not a message.
    """
    writer = _writers[message.__class__]
    buffer = bytearray(HEADER)
    try:
        writer(buffer, message)
    except (struct.error, AttributeError, TypeError, ValueError, OverflowError) as error:
        raise SerializationError(f"{type_name(message.__class__)} can not be serialized: {error}") from error
    return bytes(buffer)


def deserialize(data: bytes | bytearray | memoryview, cls: Any) -> Any:
    """Return the message of class `cls` in CDR bytes with header (rclpy.serialization.deserialize_message).

    Bytes after its end are ignored (real senders pad). Counts are checked against the remaining bytes before anything is
    allocated.

    Raises:
        DeserializationError: the bytes are not such a message.
        TypeError: `cls` is not a message class.
    """
    reader = _readers[cls]
    if data.__class__ is not bytes:
        data = bytes(data)
    if len(data) < 4 or data[0] != 0 or data[1] != _LITTLE_ENDIAN:
        raise DeserializationError(f"{type_name(cls)}: {_header_problem(data)}")
    try:
        return reader(data, 4, len(data))[0]
    except (struct.error, ValueError) as error:
        raise DeserializationError(f"{type_name(cls)}: {len(data)} bytes are no such message: {error}") from error


def _header_problem(data: bytes | bytearray | memoryview) -> str:
    if len(data) < 4:
        return f"{len(data)} bytes are too few for a CDR header of 4 bytes"
    if data[0] == 0 and data[1] == 0:
        return "big-endian CDR is not supported"
    return f"unknown CDR encapsulation {data[0]:#04x} {data[1]:#04x}"
