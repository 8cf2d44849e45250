"""Messages as CDR bytes and back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rclpy._day6.incidental import also
from rclpy._rclpy_pybind11 import RMWError
from rclpy.type_support import check_for_type_support

if TYPE_CHECKING:
    from rclpy.type_support import Msg, MsgT

__getattr__ = also(__name__, "Msg")


def serialize_message(message: Msg) -> bytes:
    """Return a message as CDR bytes, with the 4 bytes that name the encoding."""
    if isinstance(message, type):
        raise AttributeError("type object 'type' has no attribute '_TYPE_SUPPORT'")
    check_for_type_support(type(message))
    from day6_core.interfaces import serialize

    return serialize(message)


def deserialize_message(serialized_message: bytes, message_type: type[MsgT]) -> MsgT:
    """Return the message in CDR bytes.

    Raises:
        RMWError: for bytes that don't fit the type.
    """
    check_for_type_support(message_type)
    if not isinstance(serialized_message, bytes):
        raise TypeError(
            "rclpy_deserialize(): incompatible function arguments. The following argument types are supported:\n"
            f"    1. (arg0: bytes, arg1: object) -> object\n\nInvoked with: {serialized_message!r}, {message_type!r}"
        )
    from day6_core.interfaces import DeserializationError, deserialize, type_name

    try:
        message: MsgT = deserialize(serialized_message, message_type)
        return message
    except DeserializationError:
        package, kind, name = type_name(message_type).split("/")
        raise RMWError(
            "failed to deserialize ROS message: Fast CDR exception deserializing message of type "
            f"{package}::{kind}::dds_::{name}_., at /project/src/type_support_common.cpp:139"
        ) from None
