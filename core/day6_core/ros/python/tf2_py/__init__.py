"""The ROS package tf2_py: the transform buffer without nodes and topics, in pure Python.

It imports only messages, rclpy's types and its logger; tf2_ros and tf2_geometry_msgs build on it.
"""

from tf2_py._buffer_core import BufferCore as BufferCore
from tf2_py._exceptions import ConnectivityException as ConnectivityException
from tf2_py._exceptions import ExtrapolationException as ExtrapolationException
from tf2_py._exceptions import InvalidArgumentException as InvalidArgumentException
from tf2_py._exceptions import LookupException as LookupException
from tf2_py._exceptions import TimeoutException as TimeoutException
from tf2_py._exceptions import TransformException as TransformException

__all__ = [
    "BufferCore",
    "ConnectivityException",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "TimeoutException",
    "TransformException",
]
