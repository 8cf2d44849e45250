"""The display types, one module each; a type's class is imported only when somebody adds it."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.display import Display

PACKAGE = "rviz_default_plugins"

TYPES: dict[str, tuple[str, str, str]] = {
    "AccelStamped": ("screw", "AccelStampedDisplay", "geometry_msgs/msg/AccelStamped"),
    "Axes": ("axes", "AxesDisplay", ""),
    "Camera": ("camera", "CameraDisplay", "sensor_msgs/msg/Image"),
    "CameraInfo": ("camera_info", "CameraInfoDisplay", "sensor_msgs/msg/CameraInfo"),
    "Effort": ("effort", "EffortDisplay", "sensor_msgs/msg/JointState"),
    "FluidPressure": ("scalar", "FluidPressureDisplay", "sensor_msgs/msg/FluidPressure"),
    "Grid": ("grid", "GridDisplay", ""),
    "GridCells": ("flat", "GridCellsDisplay", "nav_msgs/msg/GridCells"),
    "Illuminance": ("scalar", "IlluminanceDisplay", "sensor_msgs/msg/Illuminance"),
    "Image": ("image", "ImageDisplay", "sensor_msgs/msg/Image"),
    "InteractiveMarkers": (
        "interactive_markers",
        "InteractiveMarkersDisplay",
        "visualization_msgs/msg/InteractiveMarkerUpdate",
    ),
    "LaserScan": ("laser_scan", "LaserScanDisplay", "sensor_msgs/msg/LaserScan"),
    "Map": ("map", "MapDisplay", "nav_msgs/msg/OccupancyGrid"),
    "Marker": ("marker", "MarkerDisplay", "visualization_msgs/msg/Marker"),
    "MarkerArray": ("marker", "MarkerArrayDisplay", "visualization_msgs/msg/MarkerArray"),
    "Odometry": ("odometry", "OdometryDisplay", "nav_msgs/msg/Odometry"),
    "Path": ("path", "PathDisplay", "nav_msgs/msg/Path"),
    "PointCloud": ("point_cloud", "PointCloudDisplay", "sensor_msgs/msg/PointCloud"),
    "PointCloud2": ("point_cloud2", "PointCloud2Display", "sensor_msgs/msg/PointCloud2"),
    "PointStamped": ("poses", "PointStampedDisplay", "geometry_msgs/msg/PointStamped"),
    "Polygon": ("flat", "PolygonDisplay", "geometry_msgs/msg/PolygonStamped"),
    "Pose": ("poses", "PoseDisplay", "geometry_msgs/msg/PoseStamped"),
    "PoseArray": ("poses", "PoseArrayDisplay", "geometry_msgs/msg/PoseArray"),
    "PoseWithCovariance": (
        "poses",
        "PoseWithCovarianceDisplay",
        "geometry_msgs/msg/PoseWithCovarianceStamped",
    ),
    "Range": ("range", "RangeDisplay", "sensor_msgs/msg/Range"),
    "RelativeHumidity": ("scalar", "RelativeHumidityDisplay", "sensor_msgs/msg/RelativeHumidity"),
    "RobotModel": ("robot_model", "RobotModelDisplay", ""),
    "Temperature": ("scalar", "TemperatureDisplay", "sensor_msgs/msg/Temperature"),
    "TF": ("tf", "TFDisplay", ""),
    "TwistStamped": ("screw", "TwistStampedDisplay", "geometry_msgs/msg/TwistStamped"),
    "Wrench": ("screw", "WrenchDisplay", "geometry_msgs/msg/WrenchStamped"),
}
"""Type -> module, class, and the message type by which Add by topic finds it (RobotModel and TF are not found so)."""

LEFT_OUT = (f"{PACKAGE}/DepthCloud",)
"""Classes of the original that have none here."""


def display_class(type_name: str) -> type[Display]:
    """The class of a type of `TYPES`. Raises KeyError."""
    module, name, _ = TYPES[type_name]
    found: type[Display] = getattr(import_module(f"{__name__}.{module}"), name)
    return found


def types_for(message_type: str) -> list[str]:
    """The display types that show messages of this type."""
    return [name for name, (_, _, shown) in TYPES.items() if shown == message_type]


def unknown_class(class_id: str) -> str:
    """What pluginlib says of a display class that nobody declared."""
    declared = "".join(f" {PACKAGE}/{name}" for name in sorted(TYPES))
    text = f"According to the loaded plugin descriptions the class {class_id} with base class type rviz_common::Display"
    return f"{text} does not exist. Declared types are {declared}"
