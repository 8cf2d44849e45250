"""What may be wrong in a message, one at a time; and that what sensors send where there is nothing to measure is right."""

from __future__ import annotations

import math
from typing import Any

from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion, Twist, Vector3
from nav_msgs.msg import OccupancyGrid, Path
from sensor_msgs.msg import BatteryState, Image, Imu, JointState, LaserScan, NavSatFix, PointCloud2, PointField, Range
from std_msgs.msg import Float32, Float32MultiArray, Float64MultiArray, MultiArrayDimension, MultiArrayLayout, String
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from day6_core.interfaces import type_name
from day6_core.ros.programs.day6_inspector.message_checks import is_worth_a_look, odd
from tests.support.folded import folded

NAN, INF = math.nan, math.inf


def scan(count: int = 5, **fields: Any) -> LaserScan:
    usual = {"angle_min": -1.0, "angle_max": 1.0, "angle_increment": 0.5, "range_min": 0.1, "range_max": 10.0}
    return LaserScan(**{"ranges": [1.0] * count, **usual, **fields})


def pose(x: float = 0.0, **turned: float) -> PoseStamped:
    return PoseStamped(pose=Pose(position=Point(x=x), orientation=Quaternion(**turned)))


def image(encoding: str, step: int, size: int) -> Image:
    return Image(encoding=encoding, width=4, height=2, step=step, data=bytes(size))


def cloud(step: int, row: int, size: int) -> PointCloud2:
    fields = [PointField(name="z", offset=8, datatype=PointField.FLOAT32, count=1)]
    return PointCloud2(fields=fields, width=2, height=2, point_step=step, row_step=row, data=bytes(size))


def grid(cells: int, resolution: float) -> OccupancyGrid:
    made = OccupancyGrid(data=[0] * cells)
    made.info.width, made.info.height, made.info.resolution = 2, 2, resolution
    return made


def trajectory(**fields: list[float]) -> JointTrajectory:
    return JointTrajectory(joint_names=["a", "b"], points=[JointTrajectoryPoint(**fields)])


def layout(size: int) -> MultiArrayLayout:
    return MultiArrayLayout(dim=[MultiArrayDimension(size=size)])


CASES: dict[str, tuple[Any, str]] = {
    "a twist": (Twist(linear=Vector3(x=1.0)), ""),
    "NaN in a field of a field": (Twist(linear=Vector3(x=NAN)), "not_finite linear.x nan"),
    "minus infinity": (Twist(angular=Vector3(z=-INF)), "not_finite angular.z -inf"),
    "in a list of messages": (Path(poses=[pose(), pose(NAN)]), "not_finite poses[1].pose.position.x nan"),
    "in a list of numbers": (Float64MultiArray(data=[0.0, INF]), "not_finite data[1] inf"),
    "huge numbers whose sum is infinite": (Float64MultiArray(data=[1e308, 1e308]), ""),
    "a bare number": (Float32(data=NAN), "not_finite data nan"),
    "a position that is none": (JointState(name=["a"], position=[NAN]), "not_finite position nan"),
    "velocities that nobody knows": (JointState(name=["a"], position=[0.0], velocity=[NAN], effort=[NAN]), ""),
    "a battery that doesn't measure": (BatteryState(voltage=NAN, percentage=NAN), ""),
    "no satellite": (NavSatFix(latitude=NAN, longitude=NAN), ""),
    "nothing near": (Range(range=INF), ""),
    "turned": (pose(z=-0.7071, w=0.7071), ""),
    "a quaternion of zeros": (pose(w=0.0), "quaternion pose.orientation 0"),
    "an angle for a quaternion": (pose(z=1.57), "quaternion pose.orientation 1.86"),
    "an IMU without orientation": (Imu(orientation=Quaternion(w=0.0), orientation_covariance=[-1.0] + [0.0] * 8), ""),
    "an IMU with a wrong one": (Imu(orientation=Quaternion(w=0.0)), "quaternion orientation 0"),
    "a scan": (scan(ranges=[NAN, INF, -INF, 0.0, 1.0]), ""),
    "a scan one range short": (scan(angle_max=6.28, angle_increment=0.0175, count=416), ""),
    "a scan around": (scan(angle_min=0.0, angle_max=6.28, angle_increment=0.0175, count=360), ""),
    "no increment": (scan(angle_increment=0.0), "scan_angles 5 1 0"),
    "too many ranges": (scan(count=50), "scan_angles 50 5 0.5"),
    "degrees": (scan(angle_max=359.0, angle_increment=1.0, count=361), "scan_degrees 359"),
    "a blind laser": (scan(ranges=[NAN] * 5), "scan_empty 5"),
    "no range is valid": (scan(range_max=0.0), "scan_ranges 0.1 0"),
    "an image": (image("rgb8", 12, 24), ""),
    "padded rows": (image("mono8", 8, 16), ""),
    "OpenCV's name of an encoding": (image("32FC2", 32, 64), ""),
    "an encoding that nobody here knows": (image("nv12", 4, 8), ""),
    "a short image": (image("rgb8", 12, 12), "data_size data 12 24"),
    "short rows": (image("bgra8", 12, 24), "data_size step 12 16"),
    "capitals": (image("BGR8", 12, 24), "image_encoding BGR8 bgr8"),
    "points": (cloud(12, 24, 48), ""),
    "points longer than their step": (cloud(8, 16, 32), "data_size point_step 8 12"),
    "rows shorter than their points": (cloud(12, 12, 24), "data_size row_step 12 24"),
    "a short cloud": (cloud(12, 24, 40), "data_size data 40 48"),
    "a map": (grid(4, 0.05), ""),
    "no map yet": (OccupancyGrid(), ""),
    "cells missing": (grid(3, 0.05), "data_size data 3 4"),
    "cells without a size": (grid(4, 0.0), "map_resolution 0"),
    "a trajectory": (trajectory(positions=[0.0, 0.0], velocities=[NAN, NAN]), ""),
    "a position missing": (trajectory(positions=[0.0]), "data_size points[0].positions 1 2"),
    "a layout that fits": (Float32MultiArray(layout=layout(2), data=[0.0, 0.0]), ""),
    "a layout that doesn't": (Float32MultiArray(layout=layout(3), data=[0.0, 0.0]), "data_size data 2 3"),
    "percent": (BatteryState(percentage=87.0), "out_of_range percentage 87 0 1"),
    "exchanged": (NavSatFix(latitude=116.4, longitude=39.9), "out_of_range latitude 116.4 -90 90"),
}
"""A message, and what is odd about it: the key and its parameters."""


@folded("case", CASES.items(), ids=lambda case: case[0])
def test_a_message_is_odd_or_it_is_not(case: tuple[str, tuple[Any, str]]) -> None:
    _, (message, said) = case
    found = [" ".join((each.key, *(value for _, value in each.parameters))) for each in odd(message, _type(message))]
    assert found == ([said] if said else [])


def _type(message: Any) -> str:
    found: str = type_name(type(message))
    return found


def test_words_alone_are_not_worth_a_look() -> None:
    assert not is_worth_a_look(String) and is_worth_a_look(Twist) and is_worth_a_look(Image)
