"""The ROS package tf2_ros: the positions of a robot's frames at any time in the last seconds.

The real package imports its modules with a star, so names like `tf2_ros.TransformStamped` exist in it by accident, and
programs use them; those that aren't needed here are imported on first access.
"""

from importlib import import_module
from typing import Any

from geometry_msgs.msg import TransformStamped as TransformStamped
from tf2_msgs.msg import TFMessage as TFMessage
from tf2_msgs.srv import FrameGraph as FrameGraph
from tf2_py import BufferCore as BufferCore
from tf2_py import ConnectivityException as ConnectivityException
from tf2_py import ExtrapolationException as ExtrapolationException
from tf2_py import InvalidArgumentException as InvalidArgumentException
from tf2_py import LookupException as LookupException
from tf2_py import TimeoutException as TimeoutException
from tf2_py import TransformException as TransformException

from tf2_ros.buffer import Buffer as Buffer
from tf2_ros.buffer_client import BufferClient as BufferClient
from tf2_ros.buffer_interface import BufferInterface as BufferInterface
from tf2_ros.buffer_interface import ConvertRegistration as ConvertRegistration
from tf2_ros.buffer_interface import NotImplementedException as NotImplementedException
from tf2_ros.buffer_interface import Stamped as Stamped
from tf2_ros.buffer_interface import TransformRegistration as TransformRegistration
from tf2_ros.buffer_interface import TypeException as TypeException
from tf2_ros.buffer_interface import convert as convert
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster as StaticTransformBroadcaster
from tf2_ros.transform_broadcaster import TransformBroadcaster as TransformBroadcaster
from tf2_ros.transform_listener import DEFAULT_STATIC_TF_TOPIC as DEFAULT_STATIC_TF_TOPIC
from tf2_ros.transform_listener import DEFAULT_TF_TOPIC as DEFAULT_TF_TOPIC
from tf2_ros.transform_listener import TransformListener as TransformListener

_BY_ACCIDENT = {
    "ActionClient": "rclpy.action.client",
    "Clock": "rclpy.clock",
    "DurabilityPolicy": "rclpy.qos",
    "Duration": "rclpy.duration",
    "Future": "rclpy.task",
    "Header": "std_msgs.msg",
    "HistoryPolicy": "rclpy.qos",
    "JumpThreshold": "rclpy.clock",
    "LookupTransform": "tf2_msgs.action",
    "Node": "rclpy.node",
    "PointCloud2": "sensor_msgs.msg",
    "PointStamped": "geometry_msgs.msg",
    "PoseStamped": "geometry_msgs.msg",
    "PoseWithCovarianceStamped": "geometry_msgs.msg",
    "QoSProfile": "rclpy.qos",
    "ReentrantCallbackGroup": "rclpy.callback_groups",
    "SingleThreadedExecutor": "rclpy.executors",
    "Thread": "threading",
    "Time": "rclpy.time",
    "TimeJump": "rclpy.clock",
    "Vector3Stamped": "geometry_msgs.msg",
    "deepcopy": "copy",
    "sleep": "time",
}
_MODULES_BY_ACCIDENT = {
    "builtin_interfaces": "builtin_interfaces.msg",
    "rclpy": "rclpy",
    "tf2": "tf2_py",
    "threading": "threading",
    "warnings": "warnings",
}


def __getattr__(name: str) -> Any:
    if name in _BY_ACCIDENT:
        value = getattr(import_module(_BY_ACCIDENT[name]), name)
    elif name in _MODULES_BY_ACCIDENT:
        value = import_module(_MODULES_BY_ACCIDENT[name])
        if name == "builtin_interfaces":
            value = import_module(name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = value
    return value
