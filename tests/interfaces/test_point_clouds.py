"""sensor_msgs_py, laser_geometry, tf2_sensor_msgs, angles, action_tutorials_interfaces: the real ones' results and texts."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest
from sensor_msgs.msg import LaserScan, PointCloud2, PointField
from sensor_msgs_py import numpy_compat, point_cloud2
from std_msgs.msg import Header

F32, U8 = PointField.FLOAT32, PointField.UINT8
XYZ = [PointField(name=name, offset=4 * number, datatype=F32, count=1) for number, name in enumerate("xyz")]
POINTS = [(0.0, 0.5, 1.0), (1.0, float("nan"), 2.0), (2.0, 2.5, 3.0)]


def field(name: str = "x", count: int = 1, kind: int = F32, offset: int = 0) -> PointField:
    return PointField(name=name, offset=offset, datatype=kind, count=count)


def test_a_cloud_of_points_is_written_and_read_again() -> None:
    cloud = point_cloud2.create_cloud_xyz32(Header(frame_id="lidar"), POINTS)
    assert (cloud.header.frame_id, cloud.height, cloud.width, cloud.point_step, cloud.row_step) == (
        "lidar",
        1,
        3,
        12,
        36,
    )
    assert (cloud.is_dense, cloud.is_bigendian) == (False, sys.byteorder != "little")
    assert cloud.fields == XYZ and len(cloud.data) == 36
    assert point_cloud2.read_points(cloud).dtype.names == ("x", "y", "z")
    assert point_cloud2.read_points(cloud, ["z", "x"], uvs=[2]).tolist() == [(3.0, 2.0)]
    assert point_cloud2.read_points_numpy(cloud, skip_nans=True).tolist() == [[0.0, 0.5, 1.0], [2.0, 2.5, 3.0]]
    first = point_cloud2.read_points_list(cloud, ["x", "y"])[0]
    assert repr(first) == f"Point(x={np.float32(0.0)!r}, y={np.float32(0.5)!r})"


def test_fields_of_several_values_and_without_a_name() -> None:
    kind = point_cloud2.dtype_from_fields([field("", 2), field("c", kind=U8, offset=8)], point_step=12)
    assert kind.names == ("unnamed_field_0_0", "unnamed_field_0_1", "c")
    assert [kind.fields[name][1] for name in kind.names] == [0, 4, 8] and kind.itemsize == 12
    assert point_cloud2.DUMMY_FIELD_PREFIX == "unnamed_field"


def test_an_organised_cloud_keeps_its_shape() -> None:
    cloud = point_cloud2.create_cloud(Header(), XYZ, np.arange(18, dtype=np.float32).reshape(3, 2, 3))
    assert (cloud.width, cloud.height) == (3, 2)
    assert point_cloud2.read_points(cloud, reshape_organized_cloud=True).shape == (3, 2)
    assert point_cloud2.read_points_numpy(cloud, ["x"]).ravel().tolist() == [0.0, 3.0, 6.0, 9.0, 12.0, 15.0]


def test_a_cloud_of_the_other_byte_order_is_turned_round() -> None:
    data = np.array(POINTS[:1], ">f4" if sys.byteorder == "little" else "<f4").tobytes()
    cloud = PointCloud2(fields=XYZ, height=1, width=1, point_step=12, data=data, is_bigendian=sys.byteorder == "little")
    assert point_cloud2.read_points(cloud).tolist() == [POINTS[0]]


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: point_cloud2.read_points(None), "Cloud is not a sensor_msgs.msg.PointCloud2"),
        (lambda: point_cloud2.read_points_list(None), "cloud is not a sensor_msgs.msg.PointCloud2"),
        (
            lambda: point_cloud2.read_points(point_cloud2.create_cloud_xyz32(Header(), POINTS), ["w"]),
            "Requests field is not in the fields of the PointCloud!",
        ),
        (lambda: point_cloud2.dtype_from_fields([field(count=0)]), "Can't process fields with count = 0."),
        (lambda: point_cloud2.dtype_from_fields([field(), field()]), "Duplicate field names are not allowed!"),
        (
            lambda: point_cloud2.create_cloud(Header(), XYZ, np.zeros((1, 1, 1, 3), np.float32)),
            "Too many dimensions for organized cloud!             Points can only be organized in max. two dimensional space",
        ),
        (
            lambda: point_cloud2.read_points_numpy(PointCloud2(fields=[field(), field("c", kind=U8)])),
            "All fields need to have the same datatype. Use `read_points()` otherwise.",
        ),
    ],
)
def test_what_does_not_fit_is_refused_in_the_words_of_the_real_one(call: Any, text: str) -> None:
    with pytest.raises(AssertionError) as refusal:
        call()
    assert str(refusal.value) == text


def test_the_functions_for_old_numpy_are_there() -> None:
    structured = numpy_compat.unstructured_to_structured(np.zeros((2, 3)), names=["a", "b", "c"])
    assert numpy_compat.structured_to_unstructured(structured).shape == (2, 3)


def test_the_action_of_the_old_tutorial_can_be_imported() -> None:
    from action_tutorials_interfaces.action import Fibonacci

    assert Fibonacci.Goal(order=5).order == 5
    assert Fibonacci.Feedback.get_fields_and_field_types() == {"partial_sequence": "sequence<int32>"}
    assert list(Fibonacci.Result().sequence) == []


def test_the_type_of_a_file_s_name_is_where_launch_has_it() -> None:
    from launch.utilities.typing_file_path import FilePath

    assert FilePath.__name__ == "FilePath" and [each.__name__ for each in FilePath.__constraints__][:2] == [
        "str",
        "bytes",
    ]


def test_a_laser_scan_becomes_a_cloud_without_what_is_out_of_range() -> None:
    from laser_geometry import LaserProjection

    scan = LaserScan(angle_increment=np.pi / 2, range_min=0.1, range_max=10.0, time_increment=0.5)
    scan.ranges, scan.intensities = [2.0, float("inf"), 4.0, 0.05], [1.0, 2.0, 3.0, 4.0]
    points = point_cloud2.read_points_list(LaserProjection().projectLaser(scan))
    assert points[0]._fields == ("x", "y", "z", "intensity", "index")
    assert [pytest.approx(tuple(point), abs=1e-6) for point in points] == [(2, 0, 0, 1, 0), (-4, 0, 0, 3, 2)]
    option = LaserProjection.ChannelOption
    near = LaserProjection().projectLaser(scan, range_cutoff=3.0, channel_options=option.DISTANCE | option.TIMESTAMP)
    assert point_cloud2.read_points(near).tolist() == [(2.0, 0.0, 0.0, 2.0, 0.0)]


def test_a_cloud_is_transformed_with_the_rest_of_its_fields_untouched() -> None:
    import tf2_ros
    import tf2_sensor_msgs
    from geometry_msgs.msg import TransformStamped

    transform = TransformStamped()
    transform.header.frame_id = "map"
    transform.transform.translation.z = 5.0
    transform.transform.rotation.z = transform.transform.rotation.w = 0.5**0.5  # a quarter turn to the left
    fields = [*XYZ, field("i", kind=U8, offset=12)]
    cloud = point_cloud2.create_cloud(Header(frame_id="lidar"), fields, [(1.0, 0.0, 0.0, 7)])
    moved = tf2_sensor_msgs.do_transform_cloud(cloud, transform)
    assert (moved.header.frame_id, cloud.header.frame_id) == ("map", "lidar")
    assert point_cloud2.read_points_list(moved)[0] == pytest.approx((0.0, 1.0, 5.0, 7), abs=1e-6)
    assert tf2_ros.TransformRegistration().get(PointCloud2) is tf2_sensor_msgs.do_transform_cloud
    with pytest.raises(AssertionError, match="needs the fields x, y, and z"):
        tf2_sensor_msgs.do_transform_cloud(point_cloud2.create_cloud(Header(), [field()], [(1.0,)]), transform)


def test_ways_between_angles() -> None:
    import angles

    quarter = np.pi / 2
    assert angles.normalize_angle(3 * quarter) == pytest.approx(-quarter)
    assert angles.shortest_angular_distance(-quarter * 1.5, quarter * 1.5) == pytest.approx(-quarter)
    assert angles.two_pi_complement(quarter) == pytest.approx(-3 * quarter)
    assert angles.shortest_angular_distance_with_limits(0.5, -0.5, 0.25, -0.25) == (True, pytest.approx(2 * np.pi - 1))
    assert angles.shortest_angular_distance_with_limits(-0.5, 0.5, -0.25, 0.25)[0] is False
    assert angles.shortest_angular_distance_with_large_limits(0.0, 10.5 * np.pi, -2 * np.pi, 0.1 * np.pi) == (
        True,
        pytest.approx(-1.5 * np.pi),
    )
