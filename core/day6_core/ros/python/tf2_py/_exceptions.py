"""The exceptions of tf2. Their module is called `tf2`, as in the tracebacks of the real binding."""

from __future__ import annotations


class TransformException(Exception):
    """Base of everything a buffer raises about frames and times."""


class ConnectivityException(TransformException):
    """The two frames are in different trees."""


class LookupException(TransformException):
    """A frame does not exist, or the tree contains a loop."""


class ExtrapolationException(TransformException):
    """There is no data for the requested time."""


class InvalidArgumentException(TransformException):
    """A frame name that can never exist: empty, or with a leading slash."""


class TimeoutException(TransformException):
    """A buffer server did not respond in time."""


for _class in (
    TransformException,
    ConnectivityException,
    LookupException,
    ExtrapolationException,
    InvalidArgumentException,
    TimeoutException,
):
    _class.__module__ = "tf2"
