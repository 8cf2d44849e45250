"""Every status text of RViz, each from the situation in which the real one shows it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import pytest
from geometry_msgs.msg import Point, PoseStamped
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

from day6_urdf import shipped_model
from tests.rviz2.rviz_machine import ONE_LINK, lines

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine

# -- Global Status -----------------------------------------------------------------------------------------------------


def test_without_any_tf_the_fixed_frame_is_a_warning(machine: RVizMachine) -> None:
    rviz = machine.open()
    assert rviz.fixed_frame == "map"
    assert rviz.statuses.name == "Global Status: Warn"
    assert rviz.statuses.line("Fixed Frame") == ("Warn", "No tf data.  Actual error: Frame [map] does not exist")


def test_a_fixed_frame_that_nobody_knows_is_an_error_once_there_is_tf(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    assert rviz.statuses.name == "Global Status: Error"
    assert rviz.statuses.line("Fixed Frame") == ("Error", "Frame [map] does not exist")


def test_the_right_fixed_frame_is_ok_and_a_slash_in_front_is_taken_away(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    machine.fix("/base_link")
    assert rviz.fixed_frame == "base_link"
    assert rviz.statuses.name == "Global Status: Ok"
    assert rviz.statuses.line("Fixed Frame") == ("Ok", "OK")


# -- Grid, Axes, TF ----------------------------------------------------------------------------------------------------


def test_the_grid_of_a_frame_without_transform(machine: RVizMachine) -> None:
    rviz = machine.open()
    grid = rviz.displays[0]
    assert lines(grid) == {"Transform": ("Ok", "Ok")}
    rviz.edit(grid.child("Reference Frame"), "lidar")
    machine.settle()
    assert lines(grid) == {"Transform": ("Error", "Could not transform from [lidar] to [map]")}
    assert grid.statuses.name == "Status: Error"
    assert not rviz.scene.lines


def test_axes_of_an_unknown_frame(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    machine.fix("base_link")
    axes = machine.add("Axes")
    assert lines(axes) == {"Transform": ("Ok", "Transform OK")}
    rviz.edit(axes.child("Reference Frame"), "camera")
    machine.settle()
    assert lines(axes) == {"Transform": ("Error", "For frame [camera]: Frame [camera] does not exist")}


def test_axes_when_the_fixed_frame_does_not_exist(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    axes = machine.add("Axes")
    rviz.edit(axes.child("Reference Frame"), "lidar")
    machine.settle()
    assert lines(axes) == {"Transform": ("Error", "For frame [lidar]: Fixed Frame [map] does not exist")}


def test_axes_in_another_tree(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    machine.transform("odom", "other")
    machine.fix("base_link")
    axes = machine.add("Axes")
    rviz.edit(axes.child("Reference Frame"), "other")
    machine.settle()
    word, text = lines(axes)["Transform"]
    assert word == "Error"
    assert text == (
        "No transform to fixed frame [base_link]. TF error: [Could not find a connection between 'base_link' and 'other'"
        " because they are not part of the same tree.Tf has two or more unconnected trees.]"
    )


def test_tf_warns_of_frames_of_another_tree(machine: RVizMachine) -> None:
    machine.open()
    machine.transform("base_link", "lidar")
    machine.fix("base_link")
    tf = machine.add("TF")
    machine.transform("odom", "other")
    assert lines(tf) == {
        "base_link": ("Ok", "Transform OK"),
        "lidar": ("Ok", "Transform OK"),
        "odom": ("Warn", "No transform from [odom] to [base_link]"),
        "other": ("Warn", "No transform from [other] to [base_link]"),
    }
    assert tf.statuses.name == "Status: Warn"


def test_tf_lets_a_frame_fade_that_nobody_renews(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "arm", static=False)
    machine.fix("base_link")
    tf = machine.add("TF")
    rviz.edit(tf.child("Show Arrows"), False)
    machine.settle()
    arm = [shape.colour for shape in rviz.scene.shapes]
    assert (1.0, 0.0, 0.0, 1.0) in arm
    machine.advance(9.0)  # between one and two thirds of 15 s: turning grey
    colours = [shape.colour for shape in rviz.scene.shapes]
    assert any(0.3 < red < 1.0 and 0.0 < green < 0.7 and alpha == 1.0 for red, green, _, alpha in colours)
    machine.advance(3.0)
    assert any(alpha < 1.0 for *_, alpha in (shape.colour for shape in rviz.scene.shapes))
    machine.advance(6.0)
    assert all(alpha == 1.0 for *_, alpha in (shape.colour for shape in rviz.scene.shapes))


# -- RobotModel --------------------------------------------------------------------------------------------------------


def test_a_new_robot_model_has_no_topic(machine: RVizMachine) -> None:
    machine.open()
    assert lines(machine.add("RobotModel")) == {"Topic": ("Error", "Error subscribing: Empty topic name")}


def test_the_usual_topic_is_offered_before_what_else_fits(machine: RVizMachine) -> None:
    machine.open()
    display = machine.add("RobotModel")
    for topic in ("chatter", "robot_description"):
        machine.node.create_publisher(String, topic, 1)
    assert display.topic.options == ["/robot_description", "/chatter"]


def test_a_topic_on_which_nothing_came_is_ok(machine: RVizMachine) -> None:
    machine.open()
    assert lines(machine.add("RobotModel", "/robot_description")) == {"Topic": ("Ok", "OK")}


def test_a_topic_name_that_cannot_be_one(machine: RVizMachine) -> None:
    machine.open()
    word, text = lines(machine.add("RobotModel", "/robot description"))["Topic"]
    assert word == "Error"
    assert text.startswith("Error subscribing: Invalid topic name: ")


def test_the_car_before_anybody_moves_its_wheels(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
    machine.fix("base_link")
    display = machine.add("RobotModel", "/robot_description")
    machine.until(lambda: display.status("URDF") is not None)
    machine.settle()
    found = lines(display)
    topic = found.pop("Topic")
    assert topic[0] == "Ok" and topic[1].startswith("1 messages received at ") and topic[1].endswith(" hz.")
    assert found == {
        "URDF": ("Ok", "URDF parsed OK"),
        "base_link": ("Ok", "Transform OK"),
        "caster": ("Ok", "Transform OK"),
        "left_wheel": ("Error", "No transform from [left_wheel] to [base_link]"),
        "right_wheel": ("Error", "No transform from [right_wheel] to [base_link]"),
    }
    white = [shape for shape in rviz.scene.shapes if shape.colour == (1.0, 1.0, 1.0, 1.0)]
    assert [shape.name for shape in white] == ["left_wheel", "right_wheel"]
    assert all(shape.pose.xyz == (0.0, 0.0, 0.0) for shape in white)


def test_it_is_ok_when_joint_states_come_and_the_wheels_are_in_their_places(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
    machine.fix("base_link")
    display = machine.add("RobotModel", "/robot_description")
    machine.until(lambda: display.status("URDF") is not None)
    joints = JointState(name=["left_wheel_joint", "right_wheel_joint"], position=[0.5, 0.5])
    joints.header.stamp = machine.stamp()
    machine.publish("/joint_states", joints)
    joints.header.stamp = machine.stamp()
    machine.publish("/joint_states", joints)
    assert display.statuses.name == "Status: Ok"
    wheel = next(shape for shape in rviz.scene.shapes if shape.name == "left_wheel")
    assert wheel.pose.xyz == pytest.approx((0.0, 0.15, 0.05)) and wheel.marked


def test_a_description_that_is_no_urdf(machine: RVizMachine) -> None:
    machine.open()
    display = machine.robot("<robot name='r'><link name='a'/><link name='b'/></robot>")
    assert display.status("URDF") == ("Error", "URDF failed Model parse")


def test_links_in_a_loop_are_refused(machine: RVizMachine) -> None:
    machine.open()
    joints = "".join(
        f"<joint name='{a}{b}' type='fixed'><parent link='{a}'/><child link='{b}'/></joint>"
        for a, b in (("a", "b"), ("b", "c"), ("c", "b"))
    )
    display = machine.robot(f"<robot name='r'><link name='a'/><link name='b'/><link name='c'/>{joints}</robot>")
    assert display.status("URDF") == ("Error", "URDF failed Model parse")


def test_a_description_file_that_is_empty_or_missing(machine: RVizMachine, tmp_path) -> None:
    rviz = machine.open()
    display = machine.add("RobotModel")
    empty = tmp_path / "empty.urdf"
    empty.write_text("")
    rviz.edit(display.child("Description Source"), "File")
    rviz.edit(display.child("Description File"), str(empty))
    machine.until(lambda: display.status("URDF") is not None)
    assert lines(display) == {"URDF": ("Error", "URDF is empty")}


def test_a_description_from_a_file(machine: RVizMachine) -> None:
    rviz = machine.open()
    display = machine.add("RobotModel")
    rviz.edit(display.child("Description Source"), "File")
    rviz.edit(display.child("Description File"), str(shipped_model()))
    machine.until(lambda: display.status("URDF") is not None)
    machine.settle()
    assert display.status("URDF") == ("Ok", "URDF parsed OK")
    assert display.child("Description Topic").hidden
    assert "Topic" not in lines(display)


def test_missing_meshes(machine: RVizMachine) -> None:
    machine.open()
    mesh = "<visual><geometry><mesh filename='{}'/></geometry></visual>"
    one, two = "package://nobody/one.stl", "file:///no/such/two.dae"
    display = machine.robot(
        f"<robot name='r'><link name='b'>{mesh.format(one)}{mesh.format(two)}</link><link name='a'>{mesh.format(two)}</link>"
        "<joint name='j' type='fixed'><parent link='b'/><child link='a'/></joint></robot>"
    )
    lost_one, lost_two = (f"Could not load mesh resource '{uri}'" for uri in (one, two))
    text = f"Errors loading geometries:\n• for link 'a':\n{lost_two}\n• for link 'b':\n{lost_one}\n{lost_two}"
    assert display.status("URDF") == ("Error", text)


def test_inertia_that_cannot_be(machine: RVizMachine) -> None:
    machine.open()
    inertial = "<inertial><mass value='1'/><inertia ixx='1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial>"
    machine.robot(
        f"<robot name='r'><link name='a'/><link name='b'>{inertial}</link><joint name='j' type='continuous'>"
        "<parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint></robot>"
    )
    assert machine.running is not None
    assert (
        "The link b has unrealistic inertia, so the equivalent inertia box will not be shown." in machine.running.errors
    )


def test_a_prefix_is_put_before_every_frame(machine: RVizMachine) -> None:
    rviz = machine.open()
    display = machine.robot()
    rviz.edit(display.child("TF Prefix"), "robot1")
    machine.settle()
    assert display.status("robot1/base_link") == ("Error", "No transform from [robot1/base_link] to [map]")


# -- messages ----------------------------------------------------------------------------------------------------------


def _odometry(machine: RVizMachine, x: float = 0.0, w: float = 1.0) -> Odometry:
    message = Odometry()
    message.header.frame_id = "odom"
    message.header.stamp = machine.stamp(0)
    message.pose.pose.position.x = x
    message.pose.pose.orientation.w = w
    return message


def test_odometry_counts_and_draws_what_moved_far_enough(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("odom", "base_link")
    machine.fix("odom")
    display = machine.add("Odometry", "/odom")
    for x in (0.0, 0.05, 0.2):
        machine.publish("/odom", _odometry(machine, x))
    word, text = lines(display)["Topic"]
    assert (word, text.split(" at ")[0]) == ("Ok", "3 messages received")
    assert lines(display)["Transform"] == ("Ok", "Ok")
    assert len(rviz.scene.shapes) == 2 * 2  # shaft and head: the second message was too near the first


def test_numbers_that_are_none(machine: RVizMachine) -> None:
    machine.open()
    machine.transform("odom", "base_link")
    machine.fix("odom")
    text = ("Error", "Message contained invalid floating point values (nans or infs)")
    odometry = machine.add("Odometry", "/odom")
    machine.publish("/odom", _odometry(machine, math.nan))
    assert lines(odometry)["Topic"] == text
    path = machine.add("Path", "/plan")
    message = Path()
    message.header.frame_id = "odom"
    message.poses = [PoseStamped()]
    message.poses[0].pose.position.y = math.inf
    machine.publish("/plan", message)
    assert lines(path)["Topic"] == text


def test_a_quaternion_that_is_no_rotation(machine: RVizMachine) -> None:
    machine.open()
    machine.transform("odom", "base_link")
    machine.fix("odom")
    display = machine.add("Odometry", "/odom")
    machine.publish("/odom", _odometry(machine, w=0.5))
    assert lines(display)["Topic"] == (
        "Error",
        "Message contained unnormalized quaternion (squares of values don't add to 1)",
    )


def test_messages_wait_for_their_transform_and_are_dropped_when_too_many_wait(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    display = machine.add("Odometry", "/odom")
    for x in range(12):
        machine.publish("/odom", _odometry(machine, float(x)))
    assert lines(display)["Topic"] == ("Ok", "OK")
    assert machine.running is not None
    dropped = [line for line in machine.running.log if "Message Filter" in line]
    start = "[INFO] [rviz]: Message Filter dropping message: frame 'odom' at time 0.000 for reason"
    assert dropped == [f"{start} 'discarding message because the queue is full'"] * 2
    machine.fix("odom")
    assert not lines(display)  # a new Fixed Frame forgets statuses and the messages that wait
    machine.transform("odom", "base_link")
    machine.publish("/odom", _odometry(machine))
    assert lines(display)["Topic"][1].startswith("1 messages received")
    assert rviz.scene.shapes


def test_laser_scans(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    machine.fix("base_link")
    display = machine.add("LaserScan", "/scan")
    scan = LaserScan(angle_min=0.0, angle_max=1.5, angle_increment=0.5, range_min=0.1, range_max=10.0)
    scan.header.frame_id = "lidar"
    scan.ranges = [1.0, math.inf, 2.0, 0.01]
    machine.publish("/scan", scan)
    assert lines(display)["Points"] == ("Ok", "Showing [2] points from [1] messages")
    assert [list(map(float, point)) for point in rviz.scene.points[0].xyz] == [
        pytest.approx([1.0, 0.0, 0.0]),
        pytest.approx([2 * math.cos(1.0), 2 * math.sin(1.0), 0.0]),
    ]
    scan.time_increment = 1.0
    machine.publish("/scan", scan)
    text = "Laser scan time, computed from time_increment * len(ranges), is rather large:  3s.\n"
    text += "The display of any message will be delayed by this amount of time!"
    assert lines(display)["Scan Time"] == ("Warn", text)


def test_maps(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("map", "base_link")
    display = machine.add("Map", "/map")
    assert lines(display)["Message"] == ("Warn", "No map received")
    message = OccupancyGrid()
    message.header.frame_id = "map"
    machine.publish("/map", message)
    assert lines(display)["Map"] == ("Error", "Map is zero-sized (0x0)")
    message.info.width, message.info.height, message.info.resolution = 2, 2, 0.5
    message.data = [0, 100, -1]
    machine.publish("/map", message)
    assert lines(display)["Map"] == (
        "Error",
        "Data size doesn't match width*height: width = 2, height = 2, data size = 3",
    )
    message.data = [0, 100, -1, 50]
    message.info.resolution = math.nan
    machine.publish("/map", message)
    assert lines(display)["Map"] == ("Error", "Message contained invalid floating point values (nans or infs)")
    message.info.resolution = 0.5
    machine.publish("/map", message)
    assert lines(display)["Message"] == ("Ok", "Map received")
    assert lines(display)["Map"] == ("Ok", "Map OK")
    assert rviz.scene.images[0].pixels[..., :3].tolist() == [
        [[255, 255, 255], [0, 0, 0]],
        [[0x70, 0x89, 0x86], [128, 128, 128]],
    ]


def _marker(kind: int = Marker.CUBE, **fields) -> Marker:
    marker = Marker(ns="shapes", id=7, type=kind, action=Marker.ADD, **fields)
    marker.header.frame_id = "base_link"
    marker.scale.x = marker.scale.y = marker.scale.z = 1.0
    marker.color.r = marker.color.a = 1.0
    marker.pose.orientation.w = 1.0
    return marker


def test_markers_and_what_is_wrong_with_them(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    machine.fix("base_link")
    display = machine.add("Marker", "/shapes")
    assert lines(display) == {"Topic": ("Ok", "OK"), "Array Topic": ("Ok", "OK")}
    machine.publish("/shapes", _marker())
    assert "shapes/7" not in lines(display)
    assert [shape.kind for shape in rviz.scene.shapes] == ["box"]
    wrong: list[tuple[Marker, tuple[str, str]]] = []
    flat = _marker()
    flat.scale.z = 0.0
    wrong.append((flat, ("Warn", "Scale of 0 in one of x/y/z")))
    bad = _marker()
    bad.pose.position.x = math.nan
    wrong.append((bad, ("Error", "Contains invalid floating point values (nans or infs)")))
    odd = _marker(Marker.LINE_LIST, points=[Point()])
    wrong.append((odd, ("Error", "Line list marker [shapes/7] has an odd number of points.")))
    arrow = _marker(Marker.ARROW, points=[Point()])
    text = "Arrow marker [shapes/7] only specified one point of a point to point arrow."
    wrong.append((arrow, ("Error", text)))
    thin = _marker(Marker.ARROW, points=[Point(), Point(x=1.0)])
    thin.scale.x = thin.scale.y = 0.0
    wrong.append((thin, ("Warn", "Scale of 0 in both x and y")))
    wrong.append((_marker(Marker.TRIANGLE_LIST), ("Error", "TriMesh marker [shapes/7] has no points.")))
    four = _marker(Marker.TRIANGLE_LIST, points=[Point()] * 4)
    text = "TriMesh marker [shapes/7] has a point count which is not divisible by 3 [4]"
    wrong.append((four, ("Error", text)))
    for marker, status in wrong:
        machine.publish("/shapes", marker)
        assert lines(display)["shapes/7"] == status
    mesh = _marker(Marker.MESH_RESOURCE, mesh_resource="package://nobody/x.stl")
    machine.publish("/shapes", mesh)
    machine.until(lambda: "shapes/7" in lines(display))
    text = "Mesh resource marker [shapes/7] could not load [package://nobody/x.stl]"
    assert lines(display)["shapes/7"] == ("Error", text)


def test_the_same_marker_twice_in_one_array(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    machine.fix("base_link")
    display = machine.add("MarkerArray", "/many")
    machine.publish("/many", MarkerArray(markers=[_marker(), _marker()]))
    assert lines(display)["Duplicate Marker Check"] == (
        "Error",
        "Multiple Markers in the same MarkerArray message had the same ns and id: (shapes, 7)",
    )
    machine.publish("/many", MarkerArray(markers=[_marker()]))
    assert "Duplicate Marker Check" not in lines(display)
    lost = _marker()
    lost.header.frame_id = "nowhere"
    machine.publish("/many", MarkerArray(markers=[lost]))
    assert lines(display)["shapes/7"] == ("Error", "For frame [nowhere]: Frame [nowhere] does not exist")
    rviz.edit(display.child("Namespaces", "shapes"), False)
    machine.settle()
    assert not rviz.scene.shapes


def test_a_marker_with_a_lifetime_ends(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("base_link", "lidar")
    machine.fix("base_link")
    machine.add("MarkerArray", "/many")
    marker = _marker()
    marker.lifetime.sec = 2
    machine.publish("/many", MarkerArray(markers=[marker]))
    assert rviz.scene.shapes
    machine.advance(3.0)
    assert not rviz.scene.shapes


# -- resets ------------------------------------------------------------------------------------------------------------


def test_reset_forgets_moving_frames_and_messages_but_not_the_robot(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.transform("odom", "base_link", static=False)
    machine.fix("odom")
    robot = machine.robot(ONE_LINK)
    display = machine.add("Odometry", "/odom")
    machine.publish("/odom", _odometry(machine))
    assert rviz.scene.shapes
    machine.do(rviz.reset)
    assert not rviz.scene.shapes
    assert robot.status("URDF") == ("Ok", "URDF parsed OK")
    assert display.received == 0
