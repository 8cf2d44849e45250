"""The demo packages of the tutorials, run as `ros2 run` runs them."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import Image, JointState, LaserScan
from std_msgs.msg import Bool

from day6_core.ros.program_index import executables, packages
from day6_core.ros.programs.rqt_image_view.decoding import ImageRequest
from day6_core.session.display import Display
from day6_urdf.check import check_text
from rclpy.qos import DurabilityPolicy, QoSProfile

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

BEGINNINGS = (
    "demo_", "examples_", "action_tutorials", "lifecycle", "composition", "turtle_tf2", "logging_demo", "dummy_", "image_tools",
)  # fmt: skip
DEMOS = [each for each in packages() if each.startswith(BEGINNINGS)]
ALL = [(package, name) for package in DEMOS for name in executables(package)]


def said(session) -> list[str]:
    """What a program logged: `node: text`."""
    return re.findall(r"(?m)^\[\w+\] \[[\d.]+\] \[([^\]]+)\]: (.*)$", session.stderr.text)


@pytest.mark.parametrize(("package", "executable"), ALL, ids=lambda each: str(each))
def test_every_demo_starts_and_ends_quietly_on_ctrl_c(machine, package, executable):
    words = {"static": ["f", *"000000"], "cam2image": ["--ros-args", "-p", "burger_mode:=True"]}
    session = machine.run(package, executable, *next((words[part] for part in words if part in executable), []))
    machine.step(1.2)
    session.interrupt()
    machine.step(0.1)
    assert "Traceback" not in session.stderr.text
    assert "Error" not in session.stderr.text.replace("RuntimeError: parameter_blackboard is not available", "")
    names = [node.name for node in machine.graph.nodes]
    assert names == []


def test_the_packages_are_where_ros2_pkg_looks(machine):
    listed = machine.ros2("pkg", "list").stdout.split()
    assert set(DEMOS) <= set(listed)
    assert machine.ros2("pkg", "xml", "demo_nodes_cpp", "-t", "version").stdout == "0.35.1\n"
    assert "demo_nodes_cpp talker\n" in machine.ros2("pkg", "executables", "demo_nodes_cpp").stdout
    share = machine.ros2("pkg", "prefix", "--share", "turtle_tf2_py").stdout
    assert share.endswith("/share/turtle_tf2_py\n")


@pytest.mark.parametrize(
    ("package", "first", "heard"),
    [
        ("demo_nodes_cpp", "Publishing: 'Hello World: 1'", "I heard: [Hello World: 1]"),
        ("demo_nodes_py", 'Publishing: "Hello World: 0"', "I heard: [Hello World: 0]"),
    ],
)
def test_a_talker_is_heard_by_its_listener(machine, package, first, heard):
    listener = machine.run(package, "listener")
    talker = machine.run(package, "talker")
    machine.step(2.1)
    assert said(talker)[0] == ("talker", first)
    assert said(listener)[0] == ("listener", heard)


@pytest.mark.parametrize("client", ["add_two_ints_client", "add_two_ints_client_async"])
@pytest.mark.parametrize("package", ["demo_nodes_cpp", "demo_nodes_py"])
def test_two_and_three_are_five(machine, package, client):
    asker = machine.run(package, client)
    machine.step(1.5)
    assert "service not available, waiting again..." in asker.stdout.text + asker.stderr.text
    server = machine.run(package, "add_two_ints_server")
    machine.step(0.5)
    assert said(asker)[-1] == ("add_two_ints_client", "Result of add_two_ints: 5")
    assert "Incoming request\na: 2 b: 3\n" in server.stderr.text


def test_an_odd_number_is_no_even_parameter(machine):
    machine.run("demo_nodes_cpp", "even_parameters_node")
    assert machine.ros2("param", "set", "/even_parameters_node", "myint", "2").stdout == "Set parameter successful\n"
    refused = machine.ros2("param", "set", "/even_parameters_node", "myint", "3")
    assert refused.stderr == "Setting parameter failed: only even integers can be set\n"


def test_the_blackboard_takes_any_parameter(machine):
    board = machine.run("demo_nodes_cpp", "parameter_blackboard")
    assert "serving '" in board.stderr.text
    assert machine.ros2("param", "set", "/parameter_blackboard", "color", "red").status == 0
    assert machine.ros2("param", "get", "/parameter_blackboard", "color").stdout == "String value is: red\n"
    client = machine.run("demo_nodes_py", "async_param_client")
    machine.step(1.0)
    assert ("async_param_client", "    - string_parameter: Fee Fi Fo Fum") in said(client)
    assert ("async_param_client", "        value: A turtle is never late") in said(client)


def test_parameters_are_listed_and_got(machine):
    lister = machine.run("demo_nodes_cpp", "list_parameters")
    machine.step(0.5)
    assert "Parameter names:\n bar\n foo\n foo.first\n foo.second\nParameter prefixes:\n foo\n" in lister.stderr.text
    getter = machine.run("demo_nodes_cpp", "set_and_get_parameters")
    machine.step(0.5)
    assert (
        "Parameter name: foo\nParameter value (integer): 2\n"
        "Parameter name: baz\nParameter value (double): 1.450000\n"
        "Parameter name: foobarbaz\nParameter value (bool_array): [true, false]\n"
        "Parameter name: toto\nParameter value (byte_array): [0xff, 0x7f]\n"
    ) in getter.stderr.text


def test_ten_parameter_events_are_heard(machine):
    session = machine.run("demo_nodes_cpp", "parameter_events")
    machine.step(1.0)
    assert session.stderr.text.count("Parameter event:") == 10
    assert [node.name for node in machine.graph.nodes] == []


def test_one_off_timers_ring_once(machine):
    for name in ("one_off_timer", "reuse_timer"):
        session = machine.run("demo_nodes_cpp", name)
        machine.step(9.5)
        texts = [text for _, text in said(session)]
        assert texts.count("in periodic_timer callback") == 4
        assert texts.count("in one_off_timer callback") == 2
        session.interrupt()
        machine.step()


@pytest.mark.parametrize(
    ("package", "last"),
    [
        ("action_tutorials_py", "Result: array('i', [0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55])"),
        ("action_tutorials_cpp", "Result received: 0 1 1 2 3 5 8 13 21 34 55 "),
    ],
)
def test_fibonacci_numbers_come_one_a_second(machine, package, last):
    machine.run(package, "fibonacci_action_server")
    client = machine.run(package, "fibonacci_action_client")
    machine.step(5.0)
    assert len(said(client)) < 10
    machine.step(6.0)
    assert said(client)[-1] == ("fibonacci_action_client", last)


@pytest.mark.parametrize("package", ["action_tutorials_py", "action_tutorials_cpp"])
@pytest.mark.parametrize("name", ["jazzy", "kilted"])
def test_since_kilted_a_parameter_lets_the_action_demos_tell_what_they_do(machine, in_distribution, package, name):
    in_distribution(name)
    ros_args = ("--ros-args", "-p")
    machine.run(package, "fibonacci_action_server", *ros_args, "action_server_configure_introspection:=contents")
    echo = machine.start("action", "echo", "/fibonacci", "example_interfaces/action/Fibonacci", "--flow-style")
    machine.step(1.0)
    machine.run(package, "fibonacci_action_client", *ros_args, "action_client_configure_introspection:=metadata")
    machine.step(2.0)
    events = re.findall(r"event_type: (\w+)\n(?:.*\n){5}request: (\[.*)", echo.stdout)
    assert bool(events) == (name == "kilted")
    if events:
        assert ("REQUEST_SENT", "[]") in events
        assert any(event == "REQUEST_RECEIVED" and "order: 10" in request for event, request in events)
    refused = machine.ros2("param", "set", "/fibonacci_action_server", "action_server_configure_introspection", "some")
    assert ("must be one of 'disabled', 'metadata', or 'contents'" in refused.stderr) == (name == "kilted")


def test_an_order_that_would_not_fit_is_refused(machine):
    machine.run("action_tutorials_cpp", "fibonacci_action_server")
    result = machine.ros2("action", "send_goal", "/fibonacci", "example_interfaces/action/Fibonacci", "{order: 47}")
    assert result.stdout.endswith("Goal was rejected.\n")


def test_queued_goals_wait_and_a_newer_goal_aborts_an_older(machine):
    goal = ("action", "send_goal", "/fibonacci", "example_interfaces/action/Fibonacci", "{order: 4}")
    queue = machine.run("examples_rclpy_minimal_action_server", "server_queue_goals")
    first, second = machine.start(*goal), machine.start(*goal)
    machine.step(7.0)
    assert "status: SUCCEEDED" in first.stdout and "status: SUCCEEDED" in second.stdout
    assert [text for _, text in said(queue) if "queue" in text] == [
        "Goal put in the queue",
        "Next goal pulled from the queue",
    ]
    queue.interrupt()
    machine.step()
    machine.run("examples_rclpy_minimal_action_server", "server_single_goal")
    first = machine.start(*goal)
    first.step(1.5)
    second = machine.start(*goal)
    second.step(6.0)
    assert "status: ABORTED" in first.stdout
    assert "status: SUCCEEDED" in second.stdout


def test_a_goal_is_cancelled_after_two_seconds(machine):
    machine.run("examples_rclpy_minimal_action_server", "server")
    client = machine.run("examples_rclpy_minimal_action_client", "client_cancel")
    machine.step(4.0)
    texts = [text for _, text in said(client)]
    assert texts[-1] == "Goal successfully canceled"
    assert texts.index("Canceling goal") < len(texts) - 1


def test_a_second_turtle_follows_the_first(machine):
    machine.run("turtlesim", "turtlesim_node")
    for turtle in ("turtle1", "turtle2"):
        machine.run(
            *("turtle_tf2_py", "turtle_tf2_broadcaster", "--ros-args"),
            *("-p", f"turtlename:={turtle}", "-r", f"__node:={turtle}_broadcaster"),
        )
    follower = machine.run("turtle_tf2_py", "turtle_tf2_listener")
    machine.step(12.0)
    assert ("turtle_tf2_frame_listener", "Successfully spawned turtle2") in said(follower)
    pose = machine.ros2("topic", "echo", "--once", "--field", "x", "/turtle2/pose").stdout
    assert abs(float(pose.split()[0]) - 5.544) < 0.5


def test_matched_events_are_told(machine):
    session = machine.run("demo_nodes_py", "matched_event_detect")
    machine.step(2.0)
    texts = [text for _, text in said(session)]
    assert texts[:3] == ["Create a new subscription.", "First subscription is connected.", "Create a new subscription."]
    assert texts[-1] == "Last publisher is disconnected."


def test_the_logger_service_changes_what_is_shown(machine):
    session = machine.run("demo_nodes_py", "use_logger_service")
    machine.step(4.0)
    texts = [text for _, text in said(session)]
    assert "Output 1 with DEBUG logger level." not in texts
    assert "Output 2 with DEBUG logger level." in texts
    assert "Output 3 with INFO logger level." not in texts
    assert [text for text in texts if text.startswith("Output 4 with")] == ["Output 4 with ERROR logger level."]


def test_talker_qos_ends_after_its_cycles(machine):
    session = machine.run("demo_nodes_py", "talker_qos", "--reliable", "-n", "2")
    machine.step(5.0)
    texts = [text for _, text in said(session)]
    assert texts == ["Reliable talker", 'Publishing: "Hello World: 0"', 'Publishing: "Hello World: 1"']


def test_the_logging_demo_logs_once_always_and_after_a_while_at_debug(machine):
    demo = machine.run("logging_demo", "logging_demo_main")
    machine.step(5.4)
    texts = [text for _, text in said(demo)]
    assert texts.count("Timer callback called (this will only log once)") == 1
    assert texts[-1] == "Publishing: 'Current count: 9'" and "[DEBUG]" not in demo.stderr.text
    machine.step(4.0)
    texts = [text for _, text in said(demo)][len(texts) :]
    assert texts[texts.index("Publishing: 'Current count: 12'") + 1 :][:2] == [
        "Count divides into 12 (function evaluated to true)",
        "Count is even (expression evaluated to true)",
    ]
    end = texts.index("Reseting count to 0")
    assert texts[end - 1] == "Publishing: 'Current count: 15'"
    assert texts[end + 1 : end + 3] == ["Publishing: 'Current count: 0'", "Modulo divisor cannot be 0"]


def test_the_logger_component_sets_levels_of_its_container_only(machine):
    container = machine.run("rclcpp_components", "component_container")
    other = machine.run("demo_nodes_cpp", "listener")
    for plugin in ("composition composition::Talker", "logging_demo logging_demo::LoggerConfig"):
        assert machine.ros2("component", "load", "/ComponentManager", *plugin.split()).status == 0
    call = ("service", "call", "/config_logger", "logging_demo/srv/ConfigLogger")
    assert "success=True" in machine.ros2(*call, "{logger_name: talker, level: ERROR}").stdout
    before = len(said(container))
    machine.step(3.0)
    assert said(container)[before:] == []
    assert [text for _, text in said(other)][-1].startswith("I heard: [Hello World")
    assert "success=False" in machine.ros2(*call, "{logger_name: '', level: NOISY}").stdout
    assert said(container)[-1] == ("logger_config", "Unknown severity 'NOISY'")


def test_the_dummy_robot_swings_its_joints_before_a_scan_and_a_map(machine):
    joints, scans, maps = [], [], []

    def watch(node):
        node.create_subscription(JointState, "joint_states", joints.append, 10)
        node.create_subscription(LaserScan, "scan", scans.append, 10)
        node.create_subscription(OccupancyGrid, "map", maps.append, LATCHED)

    machine.node("watcher", watch)
    laser = machine.run("dummy_sensors", "dummy_laser")
    for package, executable in (("dummy_sensors", "dummy_joint_states"), ("dummy_map_server", "dummy_map_server")):
        machine.run(package, executable)
    machine.step(2.05)
    assert len(joints) in (101, 102) and len(scans) in (60, 61, 62) and len(maps) == 3
    assert list(joints[0].name) == ["single_rrbot_joint1", "single_rrbot_joint2"]
    assert list(joints[4].position) == [math.sin(0.5)] * 2
    assert ("dummy_laser", "scan size:\t1081") in said(laser)
    assert list(scans[2].ranges) == pytest.approx([math.sin(0.3)] * 1081, abs=1e-6)
    assert [list(grid.data).index(100) for grid in maps] == [2, 3, 4]
    assert maps[0].header.frame_id == "world" and maps[0].info.width == maps[0].info.height == 100


def test_the_arm_of_the_dummy_robot_stands_on_the_world(machine):
    share = machine.ros2("pkg", "prefix", "--share", "dummy_robot_bringup").stdout.strip()
    robot = check_text(Path(share, "launch", "single_rrbot.urdf").read_text(encoding="utf-8")).robot
    moving = [joint.name for joint in robot.joints if joint.type == "continuous"]
    assert moving == ["single_rrbot_joint1", "single_rrbot_joint2"]
    assert "single_rrbot_hokuyo_link" in [link.name for link in robot.links]


def test_pictures_of_burgers_are_published_and_told_of(machine):
    pictures = []
    machine.node("watcher", lambda node: node.create_subscription(Image, "image", pictures.append, 10))
    shown = machine.run("image_tools", "showimage")
    camera = machine.run("image_tools", "cam2image", "--ros-args", "-p", "burger_mode:=True", "-p", "width:=200")
    machine.step(0.17)
    assert said(camera)[:2] == [("cam2image", "Publishing image #1"), ("cam2image", "Publishing image #2")]
    assert said(shown)[:3] == [
        ("showimage", "Subscribing to topic 'image'"),
        ("showimage", "There is no screen for the window: the node runs without it"),
        ("showimage", "Received image #camera_frame"),
    ]
    assert "\nReceived image #camera_frame\n" in shown.stderr.text
    first, second = pictures[:2]
    assert (first.width, first.height, first.step, first.encoding) == (200, 240, 600, "bgr8")
    assert len(first.data) == 200 * 240 * 3 and any(first.data) and first.data != second.data


@pytest.mark.parametrize(
    ("words", "title"), [((), "/image"), (("-p", "window_name:=front"), "front"), (("-p", "show_image:=false"), "")]
)
def test_the_first_picture_opens_a_window_that_shows_the_newest(machine, words, title):
    display = Display()
    shown = machine.run("image_tools", "showimage", *(("--ros-args", *words) if words else ()), display=display)
    machine.step(0.1)
    assert display.windows == []
    machine.run("image_tools", "cam2image", "--ros-args", "-p", "burger_mode:=True")
    machine.step(0.17)
    assert [window.title for window in display.windows] == ([title] if title else [])
    assert ("showimage", "There is no screen for the window: the node runs without it") not in said(shown)
    if title:
        (window,) = display.windows
        assert window.model.received == 5
        picture = window.model.picture(ImageRequest(32, 24))
        assert (picture.image_width, picture.image_height, picture.encoding) == (320, 240, "bgr8")
        assert picture.pixels.shape == (24, 32, 3) and picture.pixels.any()
    shown.interrupt()
    machine.step(0.1)
    assert display.windows == []


def test_closing_its_window_ends_showimage(machine):
    display = Display()
    shown = machine.run("image_tools", "showimage", display=display)
    machine.run("image_tools", "cam2image", "--ros-args", "-p", "burger_mode:=True")
    machine.step(0.1)
    display.windows[0].close_by_user()
    machine.step(0.1)
    assert [node.name for node in machine.graph.nodes] == ["cam2image"]
    assert display.windows == [] and "signal_handler" not in shown.stderr.text


def test_a_picture_that_opencv_has_no_matrix_for_ends_showimage(machine):
    shown = machine.run("image_tools", "showimage")
    pictures = machine.node("camera").create_publisher(Image, "image", 10)
    pictures.publish(Image(height=2, width=2, encoding="bayer_rggb8", step=2, data=bytes(4)))
    machine.step(0.1)
    assert "what():  Unsupported encoding type\n" in shown.stderr.text


def test_a_flipped_picture_is_its_mirror_image(machine):
    pictures = []
    machine.node("watcher", lambda node: node.create_subscription(Image, "image", pictures.append, 10))
    flip = machine.node("flipper").create_publisher(Bool, "flip_image", 10)
    camera = machine.run(
        "image_tools", "cam2image", "--ros-args", "-p", "burger_mode:=True", "-p", "width:=64", "-p", "height:=64"
    )
    machine.step(0.1)
    flip.publish(Bool(data=True))
    machine.step(0.1)
    assert ("cam2image", "Set flip mode to: on") in said(camera)
    plain, mirrored = bytes(pictures[0].data), bytes(pictures[-1].data)
    rows = [plain[at : at + 192] for at in range(0, len(plain), 192)]
    turned = b"".join(b"".join(row[at : at + 3] for at in range(189, -3, -3)) for row in rows)
    assert plain != b"" and mirrored == turned  # a burger as large as the picture stays where it is


@pytest.mark.parametrize(
    ("program", "words", "error"),
    [
        ("cam2image", [], "Could not open video stream"),
        (
            "cam2image",
            ["burger_mode:=True", "width:=20"],
            "Target resolution must be at least the burger size (64 x 64)",
        ),
        ("showimage", ["reliability:=maybe"], "Invalid QoS reliability setting 'maybe'"),
        ("showimage", ["history:=none"], "Invalid QoS history setting 'none'"),
    ],
)
def test_what_a_picture_program_cannot_do_ends_it_as_in_cpp(machine, program, words, error):
    options = [word for each in words for word in ("-p", each)]
    session = machine.run("image_tools", program, *(["--ros-args", *options] if options else []))
    machine.step(0.1)
    assert (
        f"terminate called after throwing an instance of 'std::runtime_error'\n  what():  {error}\n"
        in session.stderr.text
    )


@pytest.mark.parametrize("program", ["cam2image", "showimage"])
def test_the_usage_of_a_picture_program(machine, program):
    session = machine.run("image_tools", program, "-h")
    machine.step(0.1)
    assert session.stdout.text.startswith(f"Usage: {program} [-h] [--ros-args [-p param:=value] ...]\n")
