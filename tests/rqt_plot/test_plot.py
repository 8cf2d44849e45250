"""Which number a path means, what the plot keeps, and where it is drawn."""

from __future__ import annotations

import pytest
from geometry_msgs.msg import Twist
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool, Float64MultiArray, String
from turtlesim.msg import Pose

from day6_core.ros.programs.rqt_plot.model import plot as plot_module
from day6_core.ros.programs.rqt_plot.model.axis import label, limits, seen, ticks
from day6_core.ros.programs.rqt_plot.model.field import NoField, find_topic, plottable, reader, split_paths
from day6_core.ros.programs.rqt_plot.model.lines import polyline
from tests.support.stepped_machine import SteppedMachine

# -- paths -------------------------------------------------------------------------------------------------------------


def test_a_colon_names_more_fields_of_the_same_message():
    assert split_paths("/turtle1/pose/x:y:theta") == ["/turtle1/pose/x", "/turtle1/pose/y", "/turtle1/pose/theta"]
    assert split_paths("/turtle1/pose/x") == ["/turtle1/pose/x"]


def test_the_longest_topic_that_the_path_begins_with_counts():
    topics = {"/robot": ["a/msg/A"], "/robot/pose": ["b/msg/B"], "/robot/pose2": ["c/msg/C"]}
    assert find_topic("/robot/pose/x", topics) == ("/robot/pose", "b/msg/B", "x")
    assert find_topic("robot/pose2", topics) == ("/robot/pose2", "c/msg/C", "")
    assert find_topic("/other/x", topics) is None


@pytest.mark.parametrize(
    ("type_name", "rest", "expected"),
    (
        ("turtlesim/msg/Pose", "x", ["x"]),
        ("turtlesim/msg/Pose", "", ["x", "y", "theta", "linear_velocity", "angular_velocity"]),
        ("geometry_msgs/msg/Twist", "linear", ["linear/x", "linear/y", "linear/z"]),
        ("sensor_msgs/msg/JointState", "position[0]", ["position[0]"]),
        ("sensor_msgs/msg/JointState", "header/stamp/sec", ["header/stamp/sec"]),
        ("geometry_msgs/msg/PoseWithCovariance", "covariance[35]", ["covariance[35]"]),
        ("geometry_msgs/msg/PoseArray", "poses[2]/position/x", ["poses[2]/position/x"]),
        ("std_msgs/msg/Bool", "data", ["data"]),
    ),
)
def test_a_path_is_a_number_or_all_the_numbers_inside(type_name, rest, expected):
    assert plottable("/t", type_name, rest) == expected


@pytest.mark.parametrize(
    ("type_name", "rest", "reason"),
    (
        (
            "turtlesim/msg/Pose",
            "z",
            (
                "trying to parse field 'z' of topic /t: 'z' is not a field of 'turtlesim/msg/Pose' (x, y, theta, "
                "linear_velocity, angular_velocity)"
            ),
        ),
        (
            "sensor_msgs/msg/JointState",
            "position",
            "trying to parse field 'position' of topic /t: position is a nested type but no index provided",
        ),
        ("std_msgs/msg/String", "data", "'/t/data' is a string, which cannot be plotted"),
        ("std_msgs/msg/String", "", "/t cannot be plotted"),
        ("turtlesim/msg/Pose", "x/y", "'x' is a primitive type with no field named 'y'"),
        ("turtlesim/msg/Pose", "x[0]", "trying to parse field 'x[0]' of topic /t: x is not an array or sequence"),
    ),
)
def test_a_path_that_means_no_number_says_why(type_name, rest, reason):
    with pytest.raises(NoField) as raised:
        plottable("/t", type_name, rest)
    assert str(raised.value) == reason


def test_numbers_are_taken_out_of_messages():
    joints = JointState(position=[1.5, -2.5])
    assert reader("position[1]")(joints) == -2.5
    assert reader("position[2]")(joints) is None
    assert reader("data")(Bool(data=True)) == 1.0
    assert reader("data[0]")(Float64MultiArray(data=[float("nan")])) is None
    twist = Twist()
    twist.angular.z = 1.8
    assert reader("angular/z")(twist) == 1.8


# -- axes and lines ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("low", "high"), ((0.0, 1.0), (-3.14, 9.5), (5.544, 5.545), (1e6, 1e6 + 3), (7.0, 7.0), (0.0, 0.0), (-1e-9, 1e-9))
)
def test_the_edges_are_round_and_hold_every_value(low, high):
    bottom, top, step = limits(low, high, 5)
    assert bottom - step * 1e-6 <= low <= high <= top + step * 1e-6 and bottom < top
    assert 1 <= round((top - bottom) / step) <= 7
    mantissa = f"{step:.6e}"[:8]
    assert mantissa in ("1.000000", "2.000000", "5.000000")


def test_ticks_are_labelled_with_as_many_decimals_as_they_need():
    assert [label(value, 0.5) for value in ticks(-1, 1, 4)] == ["-1.0", "-0.5", "0", "0.5"]
    assert [label(value, 5) for value in (0, 5, 10)] == ["0", "5", "10"]
    assert label(5.545, 0.001) == "5.545"


def test_only_the_points_that_are_seen_are_drawn_and_one_on_either_side():
    times = [float(number) for number in range(10)]
    assert seen(times, times, 3.5, 6.5) == (3, 8)
    assert seen(times, times, -5.0, 50.0) == (0, 10)
    assert seen([], [], 0.0, 1.0) == (0, 0)


def test_a_line_has_no_gaps_and_a_crowded_column_is_drawn_whole():
    pixels = polyline([(0, 0), (10, 5)], 11, 6)
    assert {x for x, _ in pixels} == set(range(11))
    assert polyline([(3, 1), (3, 4), (3, 2)], 5, 6) == {(3, y) for y in range(1, 5)}
    assert polyline([(-5, 2), (20, 2)], 4, 4) == {(x, 2) for x in range(4)}


# -- the program -------------------------------------------------------------------------------------------------------


@pytest.fixture
def machine():
    made = SteppedMachine()
    yield made
    made.end()


def plot_of(machine, *words):
    running = machine.start("rqt_plot", "rqt_plot", *words, screen=True)
    machine.advance(0.2)
    return machine.display.windows[-1].model, running


def test_a_curve_has_a_point_for_every_message(machine):
    publisher = machine.node.create_publisher(Pose, "/turtle1/pose", 10)
    plot, _ = plot_of(machine, "/turtle1/pose/x:y")
    for number in range(20):
        publisher.publish(Pose(x=float(number), y=-float(number)))
        machine.advance(0.05)
    x, y = plot.curves
    assert (x.path, y.path) == ("/turtle1/pose/x", "/turtle1/pose/y")
    assert x.points[1] == [float(number) for number in range(20)] and y.last == -19.0
    times = x.points[0]
    assert times[-1] - times[0] == pytest.approx(0.95)
    (ear,) = machine.node.get_subscriptions_info_by_topic("/turtle1/pose")
    assert ear.node_name.startswith("rqt_gui_py_node_")


def test_a_topic_that_comes_later_is_waited_for(machine):
    plot, _ = plot_of(machine, "/late/data", "/pose")
    assert plot.curves[0].read is None
    machine.node.create_publisher(Bool, "/late", 1).publish(Bool(data=True))
    publisher = machine.node.create_publisher(Pose, "/pose", 1)
    machine.advance(0.3)
    publisher.publish(Pose(theta=2.0))
    machine.advance(0.1)
    assert [curve.path for curve in plot.curves][:3] == ["/late/data", "/pose/x", "/pose/y"]
    assert next(curve for curve in plot.curves if curve.path == "/pose/theta").last == 2.0


def test_curves_are_added_and_removed_and_their_subscriptions_too(machine):
    machine.node.create_publisher(Pose, "/turtle1/pose", 10)
    machine.node.create_publisher(String, "/chatter", 10)
    plot, running = plot_of(machine)
    assert plot.suggestions() == [f"/turtle1/pose/{name}" for name in sorted(("x", "y", "theta", "linear_velocity",
                                                                             "angular_velocity"))]  # fmt: skip
    plot.add("/turtle1/pose/x /turtle1/pose/theta")
    plot.add("/turtle1/pose/z")
    machine.advance(0.3)
    assert [curve.path for curve in plot.curves] == ["/turtle1/pose/x", "/turtle1/pose/theta"]
    assert "'z' is not a field of" in plot.message
    plot.remove(plot.curves[0])
    machine.advance(0.3)
    plot.add("/turtle1/pose/y")
    machine.advance(0.3)
    assert [(curve.path, curve.number) for curve in plot.curves] == [("/turtle1/pose/theta", 1), ("/turtle1/pose/y", 0)]
    for curve in plot.curves:
        plot.remove(curve)
    machine.advance(0.3)
    assert machine.node.get_subscriptions_info_by_topic("/turtle1/pose") == []
    assert running.program.status is None


def test_pausing_stops_the_picture_but_not_the_listening(machine):
    publisher = machine.node.create_publisher(Bool, "/flag", 10)
    plot, _ = plot_of(machine, "/flag/data")
    plot.toggle_paused()
    stood = plot.now()
    publisher.publish(Bool(data=True))
    machine.advance(1.0)
    assert plot.now() == stood and plot.curves[0].last == 1.0
    plot.toggle_paused()
    assert plot.now() == pytest.approx(stood + 1.0)
    plot.zoom(1)
    assert plot.span == 20.0
    for _ in range(10):
        plot.zoom(-1)
    assert plot.span == 2.0
    plot.clear()
    assert plot.curves[0].last is None


def test_old_points_are_forgotten(monkeypatch):
    monkeypatch.setattr(plot_module, "MOST", 10)
    curve = plot_module.Curve("/x/data", 0)
    for number in range(100):
        curve.add(float(number), 0.0)
        assert len(curve.points[0]) == len(curve.points[1]) <= 20
    assert curve.points[0][-10:] == [float(number) for number in range(90, 100)]


def test_without_a_screen_the_values_are_printed(machine):
    publisher = machine.node.create_publisher(Pose, "/pose", 10)
    running = machine.start("rqt_plot", "rqt_plot", "/pose/x", "/nope/y")
    publisher.publish(Pose(x=2.5))
    machine.advance(1.01)
    assert running.output == "/pose/x: 2.5  /nope/y: -\n"


def test_a_wrong_field_is_told_on_the_command_line(machine):
    machine.node.create_publisher(Pose, "/pose", 10)
    running = machine.start("rqt_plot", "rqt_plot", "/pose/z")
    assert running.errors.startswith("trying to parse field 'z' of topic /pose: 'z' is not a field of")
