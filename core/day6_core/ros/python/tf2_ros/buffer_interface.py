"""The base of all buffers, which transforms stamped objects, and the registry of types that it can transform."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any

from std_msgs.msg import Header

from rclpy.duration import Duration
from rclpy.time import Time

NO_WAIT = Duration()


class BufferInterface:
    """Base of `Buffer` and `BufferClient`: transforms objects by means of their `lookup_transform`."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self,
        object_stamped: Any,
        target_frame: str,
        timeout: Duration = NO_WAIT,
        new_type: Any = None,
    ) -> Any:
        """Return a stamped object in another frame, as it was at the object's time; converted if `new_type` is given.

        Raises TypeException for a type that isn't registered (import tf2_geometry_msgs for those of geometry_msgs), else the
        errors of `lookup_transform`.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout)
        result = do_transform(object_stamped, found)
        return result if new_type is None else convert(result, new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
        new_type: Any = None,
    ) -> Any:
        """Return a stamped object in another frame at another time, through `fixed_frame`; see `transform`."""
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout
        )
        result = do_transform(object_stamped, found)
        return result if new_type is None else convert(result, new_type)

    def lookup_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return the transform from source to target frame. This one raises NotImplementedException."""
        raise NotImplementedException()

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return the transform between two frames at two times. This one raises NotImplementedException."""
        raise NotImplementedException()

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return whether `lookup_transform` would succeed. This one raises NotImplementedException."""
        raise NotImplementedException()

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return whether `lookup_transform_full` would succeed. This one raises NotImplementedException."""
        raise NotImplementedException()


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:
    """Set an object's header (`stamp` is a message) and return the object."""
    obj.header = Header(frame_id=frame_id, stamp=stamp)
    return obj


class TypeException(Exception):
    """A type that isn't registered."""

    def __init__(self, errstr: str) -> None:
        self.errstr = errstr


class NotImplementedException(Exception):
    """The buffer doesn't implement the lookup."""

    def __init__(self) -> None:
        self.errstr = "CanTransform or LookupTransform not implemented"


def _entry(table: dict[Any, Callable[[Any], Any]], key: Any) -> Callable[[Any], Any]:
    if key not in table:
        raise TypeException(f"Type {key} is not loaded or supported")
    return table[key]


class TransformRegistration:
    """The functions `(object, TransformStamped) -> object` of all types, shared by all instances."""

    _functions: dict[Any, Callable[[Any, Any], Any]] = {}

    def print_me(self) -> None:
        """Print the registry."""
        print(self._functions)

    def add(self, key: Any, callback: Callable[[Any, Any], Any]) -> None:
        """Register the function of a type."""
        self._functions[key] = callback

    def get(self, key: Any) -> Callable[[Any, Any], Any]:
        """Return the function of a type. Raises TypeException."""
        if key not in self._functions:
            raise TypeException(f"Type {key} is not loaded or supported")
        return self._functions[key]


class ConvertRegistration:
    """The functions that convert other types to messages and back, shared by all instances."""

    _to_msg: dict[Any, Callable[[Any], Any]] = {}
    _from_msg: dict[Any, Callable[[Any], Any]] = {}
    _direct: dict[Any, Callable[[Any], Any]] = {}

    def add_from_msg(self, key: Any, callback: Callable[[Any], Any]) -> None:
        """Register the function that converts a message to a `key`."""
        self._from_msg[key] = callback

    def add_to_msg(self, key: Any, callback: Callable[[Any], Any]) -> None:
        """Register the function that converts a `key` to a message."""
        self._to_msg[key] = callback

    def add_convert(self, key: tuple[Any, Any], callback: Callable[[Any], Any]) -> None:
        """Register the function that converts a `key[0]` to a `key[1]`."""
        self._direct[key] = callback

    def get_from_msg(self, key: Any) -> Callable[[Any], Any]:
        """Return the function that converts a message to a `key`. Raises TypeException."""
        return _entry(self._from_msg, key)

    def get_to_msg(self, key: Any) -> Callable[[Any], Any]:
        """Return the function that converts a `key` to a message. Raises TypeException."""
        return _entry(self._to_msg, key)

    def get_convert(self, key: tuple[Any, Any]) -> Callable[[Any], Any]:
        """Return the function that converts a `key[0]` to a `key[1]`. Raises TypeException."""
        return _entry(self._direct, key)


def convert(a: Any, b_type: Any) -> Any:
    """Return `a` as a `b_type`: by a direct conversion, as a copy of the same type, or through a message."""
    registry = ConvertRegistration()
    try:
        return registry.get_convert((type(a), b_type))(a)
    except TypeException:
        if type(a) is b_type:
            return deepcopy(a)
        to_message, from_message = registry.get_to_msg(type(a)), registry.get_from_msg(b_type)
        return from_message(to_message(a))
