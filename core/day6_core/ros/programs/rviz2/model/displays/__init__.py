"""The display types, one module each; a type's class is imported only when somebody adds it."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.display import Display

PACKAGE = "rviz_default_plugins"

TYPES: dict[str, tuple[str, str]] = {
    "AccelStamped": ("screw", "geometry_msgs/msg/AccelStamped"),
    "Axes": ("axes", ""),
    "Camera": ("camera", "sensor_msgs/msg/Image"),
    "CameraInfo": ("camera_info", "sensor_msgs/msg/CameraInfo"),
    "DepthCloud": ("depth_cloud", "sensor_msgs/msg/Image"),
    "Effort": ("effort", "sensor_msgs/msg/JointState"),
    "FluidPressure": ("scalar", "sensor_msgs/msg/FluidPressure"),
    "Grid": ("grid", ""),
    "GridCells": ("flat", "nav_msgs/msg/GridCells"),
    "Group": ("group", ""),
    "Illuminance": ("scalar", "sensor_msgs/msg/Illuminance"),
    "Image": ("image", "sensor_msgs/msg/Image"),
    "InteractiveMarkers": ("interactive_markers", "visualization_msgs/msg/InteractiveMarkerUpdate"),
    "LaserScan": ("laser_scan", "sensor_msgs/msg/LaserScan"),
    "Map": ("map", "nav_msgs/msg/OccupancyGrid"),
    "Marker": ("marker", "visualization_msgs/msg/Marker"),
    "MarkerArray": ("marker", "visualization_msgs/msg/MarkerArray"),
    "Odometry": ("odometry", "nav_msgs/msg/Odometry"),
    "Path": ("path", "nav_msgs/msg/Path"),
    "PointCloud": ("point_cloud", "sensor_msgs/msg/PointCloud"),
    "PointCloud2": ("point_cloud2", "sensor_msgs/msg/PointCloud2"),
    "PointStamped": ("poses", "geometry_msgs/msg/PointStamped"),
    "Polygon": ("flat", "geometry_msgs/msg/PolygonStamped"),
    "Pose": ("poses", "geometry_msgs/msg/PoseStamped"),
    "PoseArray": ("poses", "geometry_msgs/msg/PoseArray"),
    "PoseWithCovariance": ("poses", "geometry_msgs/msg/PoseWithCovarianceStamped"),
    "Range": ("range", "sensor_msgs/msg/Range"),
    "RelativeHumidity": ("scalar", "sensor_msgs/msg/RelativeHumidity"),
    "RobotModel": ("robot_model", ""),
    "Temperature": ("scalar", "sensor_msgs/msg/Temperature"),
    "TF": ("tf", ""),
    "TwistStamped": ("screw", "geometry_msgs/msg/TwistStamped"),
    "Wrench": ("screw", "geometry_msgs/msg/WrenchStamped"),
}
"""Type -> the module of its class `<type>Display`, and the message type by which Add by topic finds it (not RobotModel, TF)."""

_ELSEWHERE = {"Group": "rviz_common"}
"""Types of another package."""


def type_of(class_id: str) -> str | None:
    """The type of a class in a .rviz file; None if there is none here."""
    package, _, type_name = class_id.partition("/")
    return type_name if type_name in TYPES and package == _ELSEWHERE.get(type_name, PACKAGE) else None


def display_class(type_name: str) -> type[Display]:
    """The class of a type of `TYPES`. Raises KeyError."""
    module, _ = TYPES[type_name]
    found: type[Display] = getattr(import_module(f"{__name__}.{module}"), f"{type_name}Display")
    return found


def types_for(message_type: str) -> list[str]:
    """The display types that show messages of this type."""
    return [name for name, (_, shown) in TYPES.items() if shown == message_type]
