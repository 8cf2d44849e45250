"""What differs between the distributions of ROS 2, with the source of each row. Code asks the functions below.

A source names repository and file, with the branch or the change. Whole Python packages that a distribution lacks are not in its
`python_of/<name>`; interfaces whose text was another one are in `share_of/<name>`. Where no source could settle it, `UNSETTLED`
says what is done.
"""

from __future__ import annotations

import os

from day6_core.ros.distribution import DEFAULT, NAMES, current

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_SHARE = os.path.join(os.path.dirname(os.path.realpath(__file__)), "share")
_SHARES = f"{_SHARE}_of"


def _in_humble(old: Any, usual: Any, source: str) -> tuple[dict[str, Any], str]:
    return {"humble": old, "jazzy": usual}, source


def _since_lyrical(usual: Any, new: Any, source: str) -> tuple[dict[str, Any], str]:
    return {"humble": usual, "lyrical": new}, source


_SPINNING = "ros2/rclpy#1510 (10.0.1): executors.py; by later updates in Kilted (9.1.5, #1578) and Jazzy (7.1.9, #1576), see KEPT"

VALUES: dict[str, tuple[dict[str, Any], str]] = {
    "turtlesim.interfaces": (
        {"humble": "turtlesim", "kilted": "turtlesim_msgs"},
        "ros/ros_tutorials#169 (turtlesim_msgs 1.9.2); ros2/ros2_documentation#5131: Jazzy and older use turtlesim",
    ),
    "turtlesim.holonomic": _in_humble(
        False, True, "ros/ros_tutorials#131 (turtlesim 1.5.0, Iron): turtle_frame.cpp, branches humble and rolling"
    ),
    "turtlesim.newest_picture": (
        {name: name for name in NAMES[:-1]},
        "ros/ros_tutorials#167 (#168 in Jazzy 1.8.3), #196 (#197 in Lyrical 1.10.9): turtle_frame.cpp, as #148 for Iron",
    ),
    "turtlesim.keys_in_help": _in_humble(
        "GBVCDERTFQ",
        "gbvcdertfq",
        "ros/ros_tutorials#165 (turtlesim 1.8.3; #166 in Jazzy): teleop_turtle_key.cpp, branch humble",
    ),
    "action_tutorials.interfaces": _in_humble(
        "action_tutorials_interfaces", "example_interfaces", "ros2/demos#701 (after Jazzy, see KEPT)"
    ),
    "action_tutorials.introspection": (
        {"humble": False, "kilted": True},
        "ros2/demos: action_tutorials_py/fibonacci_action_server.py; Understanding-ROS2-Actions.rst of ros2_documentation",
    ),
    "demos.messages": _since_lyrical("std_msgs", "example_interfaces", "ros2/demos#674: talkers, listeners, showimage"),
    "setuptools.takes_tests_require": _since_lyrical(
        True,
        False,
        "pypa/setuptools: v72.0.0 removed it; Ubuntu 24.04 has 68.1.2, 26.04 (Lyrical, REP 2000) a later one",
    ),
    "parameters.need_more_than_a_name": _since_lyrical(
        False,
        True,
        "ros2/rclpy#1456: Node.declare_parameters raises TypeError; its words are taken to be those of the warning",
    ),
    "parameters.refusals_are_logged": _since_lyrical(
        False,
        True,
        "ros2/rclpy#1584, ros2/rclcpp#3037: parameter services warn on the node that refuses; see UNSETTLED",
    ),
    "rclpy.async_node": _since_lyrical(False, True, "ros2/rclpy#1620: rclpy/experimental/async_node.py"),
    "rclpy.deprecated_names": _since_lyrical(
        True, False, "ros2/rclpy#1456: RMW_QOS_POLICY_… of the policies and the module qos_event; see also RCLPY"
    ),
    "messages.check_fields": _in_humble(
        "always",
        "option",
        "ros2/rosidl_python#194: resource/_msg.py.em, branches humble and jazzy (where day6-tui checks unless told not to)",
    ),
    "messages.sets": _since_lyrical(
        "taken", "deprecated", "ros2/rosidl_python#243: resource/_msg.py.em (no longer `must be a set or sequence`)"
    ),
    "messages.keep_what_fits": _since_lyrical(
        False,
        True,
        "ros2/rosidl_python: setters as later than #243 generated: an array.array is kept, a tuple becomes a list (before: array "
        "copied, tuple kept)",
    ),
    "urdf.newest": _since_lyrical(
        (1, 0),
        (1, 2),
        "ros/urdfdom#235, #238 (5.1: quat_xyzw, capsule), #212, #249 (6.0: limits); Humble, Jazzy and Kilted have 3.0 and 4.0",
    ),
    "messages.have_hashes": _in_humble(
        False, True, "REP 2016 (Iron); ros2/rmw_zenoh#388: in Humble the key says TypeHashNotSupported"
    ),
    "services.have_events": _in_humble(
        False, True, "REP 2012 (Iron): Release-Iron-Irwini.rst of ros2_documentation; no service_msgs in branch humble"
    ),
    "node.describes_types": _in_humble(
        False, True, "ros2/rclpy: rclpy/type_description_service.py, in branch jazzy and not in humble"
    ),
    "rclpy.init_returns_manager": _in_humble(False, True, "ros2/rclpy#1298 (after Jazzy, see KEPT)"),
    "rclcpp.signal": (
        {"humble": "SIGINT/SIGTERM", "lyrical": "signum={number}"},
        "ros2/rclcpp#2986 (30.1.4), and #3000 for the others (16.0.17, 28.1.15, 29.5.6), which before said what Rolling says",
    ),
    "rclcpp.lifecycle_warns": (
        {"humble": False, "kilted": True},
        "ros2/rclcpp: rclcpp_lifecycle/src/lifecycle_node.cpp, branches humble, jazzy and rolling (29.3)",
    ),
    "ros2.same_names": _in_humble(
        "WARNING: Be aware that are nodes in the graph that share an exact name, this can have unintended side effects.",
        "WARNING: Be aware that there are nodes in the graph that share an exact name, which can have unintended side effects.",
        "ros2/ros2cli: ros2node/verb/list.py, branches humble and jazzy",
    ),
    "pkg.create_licences": _in_humble(
        "identitifers", "identifiers", "ros2/ros2cli: ros2pkg/verb/create.py, branches humble and jazzy"
    ),
    "param.get_arrays": _in_humble(
        "array", "list", "ros2/ros2cli: ros2param/verb/get.py, branches humble and jazzy (`.tolist()`)"
    ),
    "param.dump_to_folder": _in_humble(
        True, False, "ros2/ros2cli: --output-dir and --print in ros2param/verb/dump.py, branches humble and not jazzy"
    ),
    "param.several": _since_lyrical(
        False, True, "ros2/ros2cli#1170, #1174, #1185, #1203, #1204: ros2param/verb; Release-Lyrical-Luth.rst"
    ),
    "robot_state_publisher.names_segments": _in_humble(
        True, False, "ros/robot_state_publisher: setupURDF, branches humble and rolling (`Robot initialized`)"
    ),
    "robot_state_publisher.listens": _since_lyrical(
        False,
        True,
        "ros/robot_state_publisher#234 (3.5.3): use_robot_description_topic; #244 brought it to Kilted in September 2026",
    ),
    "bag.storage": _in_humble(
        "sqlite3", "mcap", "ros2/rosbag2#1160 (Iron); Release-Iron-Irwini.rst of ros2_documentation"
    ),
    "bag.metadata_version": _in_humble(
        5, 9, "ros2/rosbag2: rosbag2_storage/bag_metadata.hpp and yaml.hpp, branches humble and jazzy"
    ),
    "bag.topics_have_ids": _in_humble(
        False, True, "ros2/rosbag2: rosbag2_py/src/rosbag2_py/_storage.cpp, branches humble and jazzy"
    ),
    "bag.options_have_old_names": _in_humble(
        True, False, "ros2/rosbag2: rosbag2_py/src/rosbag2_py/_transport.cpp, branches humble (all, exclude) and jazzy"
    ),
    "bag.recorder_can_pause": _in_humble(
        False, True, "ros2/rosbag2: recorder.cpp, branches humble (only ~/snapshot) and jazzy"
    ),
    "bag.info_names_distribution_and_services": _in_humble(
        False, True, "ros2/rosbag2: rosbag2_py/format_bag_metadata.cpp, branches humble and jazzy"
    ),
    "bag.recorder_logs_pause_at_end": (
        {"humble": False, "jazzy": True, "lyrical": False},
        "ros2/rosbag2: Recorder::stop in recorder.cpp, branches humble, jazzy and rolling (April 2026)",
    ),
    "bag.recorder_waits": _in_humble(
        "Waiting for recording", "Wait for recording", "ros2/rosbag2: recorder.cpp, branches humble and jazzy"
    ),
    "bag.player_logs_end": _in_humble(
        False, True, "ros2/rosbag2: `Playback until timestamp` in player.cpp, branch jazzy and not humble"
    ),
    "bag.player_logs_stop": _in_humble(
        False, True, "ros2/rosbag2: `Stopping playback.` in player.cpp, branch jazzy and not humble"
    ),
    "bag.player_logs_next": _in_humble(
        True, False, "ros2/rosbag2: `Playing next message.` in player.cpp: INFO in branch humble, DEBUG in jazzy"
    ),
    "bag.progress_rate": _in_humble(0, 3, "ros2/rosbag2#1836 (after Jazzy, see KEPT)"),
    "bag.positional_topics": (
        {"humble": "taken", "kilted": "deprecated", "lyrical": "removed"},
        "ros2/rosbag2#1632: ros2bag/verb/record.py, branches jazzy (takes --topics, does not warn) and rolling; #2328 (Lyrical)",
    ),
    "bag.records_actions": (
        {"humble": False, "kilted": True},
        "ros2/rosbag2#1939, #1955, since Kilted: ros2bag/verb, rosbag2_cpp/action_utils.cpp, rosbag2_record_replay_action.md",
    ),
    "bag.play_takes_storage": _since_lyrical(True, False, "ros2/rosbag2#2328: `-s` of ros2 bag play (Lyrical)"),
    "bag.recorder_starts_again": _since_lyrical(
        False, True, "ros2/rosbag2#2248, #2330, #2357: ~/record, ~/stop, discovery, times; recorder.cpp of Lyrical"
    ),
    "bag.newer_options": _since_lyrical(
        False,
        True,
        "ros2/rosbag2#2150, #2215, #2218, #2289, #2319, #2387, #2391: rosbag2_py/_storage.pyi and _transport.pyi",
    ),
    "bag.controlled_classes": _since_lyrical(
        False,
        True,
        "ros2/rosbag2#2047, #2062, #2061, #2095: rosbag2_py/src/rosbag2_py/_transport.cpp; Release-Lyrical-Luth.rst",
    ),
    "bag.file_names": _since_lyrical(
        "name_index", "index_name_time", "ros2/rosbag2#2265; Release-Lyrical-Luth.rst of ros2_documentation"
    ),
    "service.info_verbose": _since_lyrical(
        False,
        True,
        "ros2/ros2cli#916, ros2/rclpy#1307; Release-Lyrical-Luth.rst and Understanding-ROS2-Services.rst of "
        "ros2_documentation, whose rmw_fastrtps has two endpoints for a service",
    ),
    "topic.bw_of_several": _since_lyrical(False, True, "ros2/ros2cli#1124, #1130: ros2topic/verb/bw.py (Lyrical)"),
    "topic.hz_of_all": _since_lyrical(False, True, "ros2/ros2cli#1122: ros2topic/verb/hz.py (Lyrical)"),
    "topic.echo_of_several": (
        {"humble": False, "kilted": True},
        "ros2/ros2cli#964 (0.37.0: `--field` more than once), #996 (0.38.0: entries of arrays): ros2topic/verb/echo.py",
    ),
    "ros2.chooses": _since_lyrical(False, True, "ros2/ros2cli#1151 (0.40.5): ros2cli/helpers.py, interactive_select"),
    "doctor.lacks_reports": _since_lyrical(
        ("ACTION LIST", "ROS ENVIRONMENT", "SERVICE LIST"),
        (),
        "ros2/ros2cli#1045, #1059, #1076: ros2doctor/api/{environment,service,action}.py; Release-Lyrical-Luth.rst",
    ),
    "pkg.create_rust": _since_lyrical(
        False, True, "ros2/ros2cli#1107 (0.40.3): ros2pkg/verb/create.py, resource/ament_cargo"
    ),
    "parameters.yaml_tags": _since_lyrical(
        ("str",),
        ("str", "bool", "int", "float"),
        "ros2/rcl#999, #1275: rcl_yaml_param_parser/src/parse.c; Release-Lyrical-Luth.rst of ros2_documentation",
    ),
    "rqt_robot_steering.stamped": (
        {"humble": False, "lyrical": True},
        "ros-visualization/rqt_robot_steering#18 (1.0.1: what is not kept is not the text 'true') and #28 (4.0.2, Rolling)",
    ),
    "rqt_robot_steering.parameters": (
        {"humble": False, "lyrical": True},
        "ros-visualization/rqt_robot_steering#28 (4.0.2, Rolling); before it asks for undeclared ones, '~default_topic'",
    ),
    "action.execute_callback_is_optional": _since_lyrical(
        False,
        True,
        "ros2/rclpy#1219 (10.0.2): action/server.py; by later updates in Kilted (9.1.4) and Jazzy (7.1.8), see KEPT",
    ),
    "action.feedback_only_while_executing": _since_lyrical(
        False, True, "ros2/rclpy#1639 (10.0.8); ros2/rclcpp#3283: not while canceling either"
    ),
    "lifecycle.events_are_filled": _since_lyrical(
        False,
        True,
        "ros2/rcl_interfaces#185 (stamp), ros2/rcl#1269, ros2/rclpy#1528: stamp and transition; ros2/launch_ros#495",
    ),
    "executor.refuses_second_spin": _since_lyrical(False, True, _SPINNING),
    "action.root_node": (
        {"humble": "/", "kilted": "//", "lyrical": "/"},
        "ros2/ros2cli#926, #1049 (#1052 in Humble 0.18.13, #1051 in Jazzy 0.32.5); Kilted as it was recorded",
    ),
}
"""Key -> (the value from each of these distributions on, the source)."""


def _since(name: str, source: str) -> tuple[tuple[str, ...], str]:
    return NAMES[NAMES.index(name) :], source


def _until(name: str, source: str) -> tuple[tuple[str, ...], str]:
    return NAMES[: NAMES.index(name) + 1], source


_SPLIT = VALUES["turtlesim.interfaces"][1]
_IRON = "ros2/rcl_interfaces: no such folder or file in branch humble, in branch jazzy there is (Iron)"
_COMMON = "ros2/common_interfaces: branches humble and jazzy"
_BAG = "ros2/rosbag2: rosbag2_interfaces/srv, branches humble and jazzy"
_CONTROL = "ros-controls/control_msgs: branches humble (4.8), jazzy (5.8) and master (6.8, which Kilted and later have)"

PACKAGES: dict[str, tuple[tuple[str, ...], str]] = {
    "turtlesim_msgs": _since("kilted", _SPLIT),
    "action_tutorials_interfaces": _until("jazzy", "ros2/demos#701"),
    "actionlib_msgs": _until("kilted", "ros2/common_interfaces#280"),
    "service_msgs": _since("jazzy", _IRON),
    "type_description_interfaces": _since("jazzy", _IRON),
}
"""Package -> (the distributions that have it, the source); all others are in every one."""

INTERFACES: dict[str, tuple[tuple[str, ...], str]] = {
    "turtlesim": _until("jazzy", _SPLIT),
    "rcl_interfaces/msg/LoggerLevel": _since("jazzy", _IRON),
    "rcl_interfaces/msg/SetLoggerLevelsResult": _since("jazzy", _IRON),
    "rcl_interfaces/srv/GetLoggerLevels": _since("jazzy", _IRON),
    "rcl_interfaces/srv/SetLoggerLevels": _since("jazzy", _IRON),
    "geometry_msgs/msg/PolygonInstance": _since("jazzy", _COMMON),
    "geometry_msgs/msg/PolygonInstanceStamped": _since("jazzy", _COMMON),
    "geometry_msgs/msg/Pose2D": _until("kilted", "ros2/common_interfaces#283"),
    "nav_msgs/msg/Goals": _since("jazzy", "ros2/common_interfaces#269 (after Jazzy, see KEPT)"),
    "rosbag2_interfaces/srv/Play": _since("jazzy", _BAG),
    "rosbag2_interfaces/srv/SplitBagfile": _since("jazzy", _BAG),
    "rosbag2_interfaces/srv/Stop": _since("jazzy", _BAG),
    "control_msgs/action/ExecuteMotionPrimitiveSequence": _since("jazzy", _CONTROL),
    "control_msgs/srv/SetOdometry": _since("jazzy", _CONTROL),
    **dict.fromkeys(
        (f"control_msgs/msg/{name}"
         for name in ("BatteryStateArray", "DynamicInterfaceValues", "Float64Values", "Keys", "MotionArgument",
                      "MotionPrimitive", "MotionPrimitiveSequence", "SpeedScalingFactor", "VDA5050SafetyState")),
        _since("jazzy", _CONTROL),
    ),
}  # fmt: skip
"""Interface, or package for all of its interfaces -> (the distributions that have it, the source); all others are everywhere."""

_STORES = "the type stores of rosbags 0.11 (from the message definitions of each release)"

TEXTS: dict[str, tuple[tuple[str, ...], str]] = {
    "rcl_interfaces/msg/Log": _until("humble", "ros2/rcl_interfaces: Log.msg, branches humble (byte) and jazzy (uint8)"),
    "sensor_msgs/msg/BatteryState": _until("humble", _COMMON),
    "sensor_msgs/msg/NavSatStatus": _until("humble", _COMMON),
    "sensor_msgs/msg/Range": _until("humble", _COMMON),
    "visualization_msgs/msg/Marker": _until("humble", _COMMON),
    "rosbag2_interfaces/msg/ReadSplitEvent": _until("humble", "ros2/rosbag2: rosbag2_interfaces/msg, branches humble and jazzy"),
    "rosbag2_interfaces/msg/WriteSplitEvent": _until("humble", "ros2/rosbag2: rosbag2_interfaces/msg, branches humble and jazzy"),
    "lifecycle_msgs/msg/TransitionEvent": _since("lyrical", _STORES),
    "sensor_msgs/msg/PointField": _since("lyrical", _STORES),
    "nav_msgs/msg/Trajectory": _since("lyrical", _STORES),
    "nav_msgs/msg/TrajectoryPoint": _since("lyrical", _STORES),
    "rosbag2_interfaces/msg/MessagesLostEvent": _since("lyrical", "ros2/rosbag2#2150"),
    "rosbag2_interfaces/msg/MessagesLostEventTopicStat": _since("lyrical", "ros2/rosbag2#2150"),
    **dict.fromkeys(
        (f"rosbag2_interfaces/srv/{name}"
         for name in ("IsDiscoveryRunning", "Record", "Resume", "SplitBagfile", "StartDiscovery", "Stop", "StopDiscovery")),
        _since("lyrical", "ros2/rosbag2#2248, #2330, #2357: rosbag2_interfaces/srv"),
    ),
    **dict.fromkeys(
        (f"rosgraph_msgs/msg/{name}"
         for name in ("Action", "Graph", "InterfaceType", "Node", "QoSProfile", "Service", "Topic", "TypeHash")),
        _since("lyrical", _STORES),
    ),
    "control_msgs/msg/JointTrajectoryControllerState": _until("humble", _CONTROL),
    "control_msgs/action/FollowJointTrajectory": _since("kilted", _CONTROL),
    "control_msgs/action/FollowJointWrenchTrajectory": _since("kilted", _CONTROL),
    **dict.fromkeys(
        (f"control_msgs/msg/{name}"
         for name in ("CANopenState", "EtherCATState", "GenericHardwareState", "HardwareDeviceDiagnostics",
                      "HardwareDeviceStatus", "HardwareDiagnostics", "HardwareStatus", "JointWrenchTrajectory",
                      "JointWrenchTrajectoryPoint", "PidState", "SteeringControllerCommand", "SteeringControllerStatus",
                      "VDA5050State", "WrenchFramed")),
        _since("kilted", _CONTROL),
    ),
}  # fmt: skip
"""Interface -> (the distributions that have the text in `share_of/<the first of them>`, the source); the others have that of
`share`, where there is one."""

_RCLPY = "ros2/rclpy: branches humble and jazzy"
_REMOVED = "ros2/rclpy#1456 (Lyrical: what was deprecated is removed)"
_SERVICE_INFO = "ros2/rclpy#1307 (10.0.2)"
_ACTION_GRAPH = "ros2/rclpy#1574 (10.0.4)"
_SETTERS = "ros2/rclpy#1496 (10.0.1)"

RCLPY: dict[str, tuple[tuple[str, ...], str]] = {
    "rclpy:try_shutdown": _since("jazzy", "ros2/rclpy#1302 (after Jazzy, see KEPT)"),
    "rclpy.client:Client.configure_introspection": _since("jazzy", _RCLPY),
    "rclpy.client:Client.service_name": _since("jazzy", _RCLPY),
    "rclpy.context:Context.__enter__": _since("jazzy", _RCLPY),
    "rclpy.event_handler:QoSEventHandler": _until("kilted", _REMOVED),
    "rclpy.executors:Executor.__enter__": _since("jazzy", _RCLPY),
    "rclpy.impl.rcutils_logger:RcutilsLogger.warn": _until("kilted", _REMOVED),
    "rclpy.logging:get_logger_level": _since("jazzy", _RCLPY),
    "rclpy.node:Node.add_post_set_parameters_callback": _since("jazzy", "ros2/rclpy#966"),
    "rclpy.node:Node.add_pre_set_parameters_callback": _since("jazzy", "ros2/rclpy#966"),
    "rclpy.node:Node.count_clients": _since("jazzy", _RCLPY),
    "rclpy.node:Node.count_services": _since("jazzy", _RCLPY),
    "rclpy.node:Node.get_fully_qualified_node_names": _since("jazzy", _RCLPY),
    "rclpy.node:Node.remove_post_set_parameters_callback": _since("jazzy", "ros2/rclpy#966"),
    "rclpy.node:Node.remove_pre_set_parameters_callback": _since("jazzy", "ros2/rclpy#966"),
    "rclpy.node:Node.wait_for_node": _since("jazzy", "ros2/rclpy#930"),
    "rclpy.parameter:parameter_dict_from_yaml_file": _since("jazzy", _RCLPY),
    "rclpy.service:Service.configure_introspection": _since("jazzy", _RCLPY),
    "rclpy.service:Service.service_name": _since("jazzy", _RCLPY),
    "rclpy.time:Time.to_datetime": _since("lyrical", "ros2/rclpy#1443: rclpy/time.py"),
    "rclpy.subscription:Subscription.get_publisher_count": _since("jazzy", _RCLPY),
    "rclpy.executors:Executor.is_spinning": _since("lyrical", _SPINNING),
    "rclpy.subscription:Subscription.is_cft_supported": _since("lyrical", "ros2/rclpy#1618"),
    "rclpy.action._server_goal:ServerGoalHandle.executing": _since("lyrical", "ros2/rclpy#1219: action/server.py"),
    **{f"rclpy.node:Node.get_{each}_info_by_service": _since("lyrical", _SERVICE_INFO) for each in ("clients", "servers")},
    **{f"rclpy.node:Node.get_action_{each}": _since("lyrical", _ACTION_GRAPH)
       for each in ("names_and_types", "client_names_and_types_by_node", "server_names_and_types_by_node")},
    **{f"rclpy._day6.endpoint_handles:{kind}Handle.{verb}_on_new_{what}_callback": _since("lyrical", _SETTERS)
       for kind, what in (("Subscription", "message"), ("Service", "request"), ("Client", "response"))
       for verb in ("set", "clear")},
    **{f"rclpy.timer:_TimerHandle.{verb}_on_reset_callback": _since("lyrical", _SETTERS) for verb in ("set", "clear")},
}  # fmt: skip
"""`module:name` of rclpy -> (the distributions that have it, the source); users' programs find no other ones."""

LAUNCH: dict[str, tuple[tuple[str, ...], str]] = {
    **dict.fromkeys(
        (*(f"launch.actions:{name}" for name in ("Log", "LogDebug", "LogError", "LogWarning")),
         *(f"action log_{name}" for name in ("debug", "error", "info", "warning"))),
        _since("lyrical", "ros2/launch#866: launch/actions/log.py"),
    ),
    **dict.fromkeys(
        ("launch.actions:DeclareBooleanLaunchArgument", "action bool_arg"),
        _since("lyrical", "ros2/launch#944: launch/actions/declare_boolean_launch_argument.py"),
    ),
    "substitution string-join": _since("lyrical", "ros2/launch#857: launch/substitutions/string_join_substitution.py"),
    "substitution path-join": _since("lyrical", "ros2/launch#943: launch/substitutions/path_join_substitution.py"),
}  # fmt: skip
"""`module:name` of launch, or `action` or `substitution` and its name in XML and YAML launch files -> (the distributions that
have it, the source)."""

_DEMOS = "ros2/demos: setup.py of demo_nodes_py and CMakeLists.txt of demo_nodes_cpp, branches humble and jazzy"

_DEMO_LAUNCH = "ros2/demos: the packages' launch folders, branches humble and jazzy"

LAUNCH_FILES: dict[str, tuple[str, str]] = {
    **{f"{package} {name}_launch.{kind}": (f"{name}.launch.{kind}", _DEMO_LAUNCH)
       for package, names, kinds in (
           ("composition", "composition_demo", "py"),
           ("demo_nodes_cpp", "add_two_ints add_two_ints_async talker_listener talker_listener_best_effort", "py xml"),
           ("dummy_robot_bringup", "dummy_robot_bringup", "py"),
           ("lifecycle", "lifecycle_demo", "py"),
           ("lifecycle_py", "lifecycle_demo", "py"))
       for name in names.split() for kind in kinds.split()},
    **{f"demo_nodes_cpp {name}": ("", _DEMO_LAUNCH)
       for name in ("introspect_services_launch.py", "talker_listener_launch.yaml", "talker_listener_best_effort_launch.yaml")},
}  # fmt: skip
"""Package and launch file of ours -> (its name in Humble, '' where it is not there, the source)."""

EXECUTABLES: dict[str, tuple[tuple[str, ...], str]] = {
    f"{package} {name}": _since("jazzy", _DEMOS)
    for package, names in (
        ("demo_nodes_cpp", "introspection_client introspection_service"),
        ("demo_nodes_py", "async_param_client introspection"),
        ("demo_nodes_cpp", "matched_event_detect set_parameters_callback use_logger_service"),
        ("demo_nodes_py", "matched_event_detect set_parameters_callback use_logger_service"),
    )
    for name in names.split()
}  # fmt: skip
"""Package and executable -> (the distributions that have it, the source)."""

_CLI = "ros2/ros2cli: the verb's module, branches humble and jazzy"
_BAGCLI = "ros2/rosbag2: ros2bag/verb, branches humble and jazzy"

VERBS: dict[str, tuple[tuple[str, ...], str]] = {
    "action echo": _since("jazzy", "ros2/ros2cli#978 (after Jazzy, see KEPT)"),
    "action find": _since("jazzy", "ros2/ros2cli: ros2action/verb, branches jazzy and kilted (after Jazzy, see KEPT)"),
    "action type": _since("jazzy", "ros2/ros2cli#894"),
    "bag burst": _since("jazzy", _BAGCLI),
    "service echo": _since("jazzy", _CLI),
    "service info": _since("jazzy", _CLI),
}
"""Verb of `ros2` -> (the distributions that have it, the source)."""

_QOS_OPTIONS = (
    *(
        "--qos-depth",
        "--qos-durability",
        "--qos-history",
        "--qos-liveliness",
        "--qos-liveliness-lease-duration-seconds",
    ),
    *("--qos-profile", "--qos-reliability"),
)

OPTIONS: dict[str, tuple[tuple[str, ...], tuple[str, ...], str]] = {
    "action send_goal": (("--stdin",), *_since("jazzy", _CLI)),
    "bag info": (("--sort", "--topic-name", "--verbose"), *_since("jazzy", _BAGCLI)),
    "bag play": (
        ("--clock-topics", "--clock-topics-all", "--exclude-regex", "--exclude-services", "--exclude-topics", "--input",
         "--message-order", "--playback-duration", "--playback-until-nsec", "--playback-until-sec",
         "--progress-bar-update-rate", "--publish-service-requests", "--regex", "--service-requests-source", "--services"),
        *_since("jazzy", _BAGCLI),
    ),
    "bag record": (
        ("--all-services", "--all-topics", "--compression-threads-priority", "--custom-data", "--disable-keyboard-controls",
         "--exclude-regex", "--exclude-services", "--exclude-topic-types", "--exclude-topics", "--node-name", "--services",
         "--topic-types", "--topics"),
        *_since("jazzy", _BAGCLI),
    ),
    "bag convert since lyrical": (("--input-options",), *_since("lyrical", "ros2/rosbag2#2325: ros2bag/verb/convert.py")),
    "bag play since kilted": (
        ("--actions", "--exclude-actions", "--send-actions-as-client"),
        *_since("kilted", "ros2/rosbag2#1955: ros2bag/verb/play.py"),
    ),
    "bag burst since kilted": (("--actions",), *_since("kilted", "ros2/rosbag2#1955: ros2bag/verb/burst.py")),
    "bag record since kilted": (
        ("--actions", "--all-actions", "--exclude-actions"),
        *_since("kilted", "ros2/rosbag2#1939: ros2bag/verb/record.py"),
    ),
    "bag record since lyrical": (
        ("--max-bag-files", "--max-cache-duration", "--repeat-all-transient-local", "--repeat-transient-local",
         "--static-topics-path", "--stats_max_publishing_rate"),
        *_since("lyrical", "ros2/rosbag2#2150, #2218, #2289, #2319, #2387, #2391: ros2bag/verb/record.py"),
    ),
    "interface package": (("--only-actions", "--only-msgs", "--only-srvs"), *_since("jazzy", _CLI)),
    "multicast receive": (("--group", "--port"), *_since("jazzy", _CLI)),
    "multicast send": (("--group", "--port"), *_since("jazzy", _CLI)),
    **{f"param {verb}": (("--timeout",), *_since("jazzy", "ros2/ros2cli#802"))
       for verb in ("delete", "describe", "dump", "get", "load", "set")},
    "service call": (("--stdin",), *_since("jazzy", _CLI)),
    "topic echo": (
        ("--clear", "--include-message-info", "--node-name", "--qos-liveliness", "--qos-liveliness-lease-duration-seconds",
         "--timeout"),
        *_since("jazzy", _CLI),
    ),
    "topic pub": (
        ("--max-wait-time-secs", "--qos-liveliness", "--qos-liveliness-lease-duration-seconds", "--stdin"),
        *_since("jazzy", _CLI),
    ),
    "topic pub since kilted": (("--yaml-file",), *_since("kilted", "ros2/ros2cli#925 (0.38.0): ros2topic/verb/pub.py")),
    **{f"{verb} since kilted": (_QOS_OPTIONS, *_since("kilted", f"ros2/ros2cli{source}"))
       for verb, source in (
           ("topic bw", "#935 (0.38.0): ros2topic/verb/bw.py"),
           ("topic delay", "#935 (0.38.0): ros2topic/verb/delay.py"),
           ("topic hz", "#935 (0.38.0): ros2topic/verb/hz.py"),
           ("service call", "#966 (0.38.0): ros2service/verb/call.py"),
           ("service echo", "#1036 (#1038 in Kilted 0.38.1): ros2service/verb/echo.py"),
           ("action echo", "#1036 (#1038 in Kilted 0.38.1): ros2action/verb/echo.py"),
       )},
    "action send_goal since kilted": (
        ("--timeout",), *_since("kilted", "ros2/ros2cli#1067 (#1068 in Kilted 0.38.1): ros2action/verb/send_goal.py")
    ),
    "launch since lyrical": (
        ("--log-file-name",), *_since("lyrical", "ros2/launch_ros#461: ros2launch/command/launch.py; ros2/launch#861")
    ),
    "service call since lyrical": (
        ("--timeout",), *_since("lyrical", "ros2/ros2cli#1185; #1244 quotes its usage in Lyrical")
    ),
    **{f"{verb} since lyrical": ((option,), *_since("lyrical", "ros2/ros2cli#1185 (0.40.6); ros2param/verb/get.py and load.py"))
       for verb, option in (
           *((f"param {each}", "--service-timeout") for each in ("delete", "describe", "dump", "get", "load", "set")),
           *((f"lifecycle {each}", "--timeout") for each in ("get", "list", "set")),
           *((f"component {each}", "--timeout") for each in ("list", "load", "unload")),
       )},
}  # fmt: skip
"""Verb or command of `ros2`, where it has several rows with ` since NAME` -> (options, the distributions that have them, the
source)."""

KEPT: dict[str, str] = {
    "rclpy and ros2 of Jazzy": (
        "are those of Kilted, from which everything was recorded: `with rclpy.init()`, `rclpy.try_shutdown`, "
        "`with node`, `ros2 action echo`; the action tutorials use example_interfaces; there is nav_msgs/msg/Goals"
    ),
    "pictures of turtles": "are chosen as there, one more in each distribution, but windows draw all turtles alike",
    "updates of rclpy": "after 9.1.2 of Kilted aren't told in Jazzy and Kilted: is_spinning and no second spin (#1576, #1578), "
    "ActionServer without execute_callback (#1556, #1557)",
    "capsules": "of URDF 1.1 are drawn by rviz2, too, which leaves them out in Lyrical (ros2/rviz#1734)",
    "field checks": "are on in every distribution unless ROS_PYTHON_CHECK_FIELDS=0, so a learner's mistake is told at its "
    "line; numeric arrays take what they take there (`[0, 1.5]`)",
    "the choice of a name": "is our own list and not fzf (#1151), which may be missing; without a terminal both refuse",
    "action counts of the doctor": "are counted under their names (#1076 as it was proposed has them the other way round)",
}
"""What deliberately is another one than there, and how."""

UNSETTLED: dict[str, str] = {
    "Rolling": "is Lyrical, from which it goes on: what came after May 2026 isn't told apart",
    "feedback in Lyrical": "of a goal that isn't executing is dropped with a warning (rclpy#1639), whose words are in no source "
    "at hand",
    "ros2 of Lyrical": "has the words of its own sources where those could be read; what a command says after --timeout or "
    "--service-timeout (#1185), which of its verbs choose and how they ask (#1151), a `---` after each of several fields (#964), "
    "words for a wrong entry of an array (#996) are as seemed likely; topics that come after `--all` are not followed",
    "raw messages": "are filled up to four bytes, and over 65,324 bytes are not, as measured in Kilted; older Fast DDS wasn't",
    "ros2 service call of Lyrical": "asks for a name although it was given (#1151, taken back by #1244): not imitated",
    "a package for Rust": "has no Cargo.lock (#1107): cargo asks the internet for it",
    "actions in bags": "are chosen as services are: how topic_filter.cpp of Kilted (rosbag2#1939) and the player (#1955) weigh "
    "--actions against other options, and the name of the client's log, are in no source at hand; goals are sent by clients of "
    "their services, with new IDs",
    "bags of Lyrical": "lines of the recorder are those of recorder.cpp as of April 2026, without what it says of serialization "
    "formats; --repeat-all-transient-local without a number keeps one message (#2391 says no more)",
    "message_filters": "has Chain, DeltaFilter, InputAligner, TimeSequencer and offsets in every distribution: most went back to "
    "all of them (message_filters#238, #252, #283); where a time is missing, TimeSynchronizer still raises AttributeError",
    "YAML's tags in Lyrical": "what rcl says of a value that does not fit its tag (`!!int yes`) is in no source at hand "
    "(rcl#1275)",
    "ros2 launch --log-file-name": "the words of its help are those of the change as it was proposed (launch_ros#461)",
    "a refused parameter": "makes its node warn in Lyrical (rclcpp#3037, rclpy#1584; by later updates in every distribution, "
    "where only who asked is told): the words are in no source at hand",
    "a transition's stamp": "is the time of the node's clock (rcl#1269 says no more of it)",
    "clients and servers in Lyrical": "have two GIDs and QoS profiles each, as with rmw_fastrtps; with no_mangle (rclpy#1307) "
    "none are found; how they are indented as text, and the names of the arguments of Node's functions for actions (#1574), are "
    "as seemed likely",
    "actions without execute_callback": "are as in #1219 of April 2024: `executing()`, results of `succeed`, `abort` and "
    "`canceled`, the warning of a server that does nothing",
    "urdfdom of Lyrical": "the numbers of lines in its messages are those of urdfdom 4.0.1 and 5.1; that URDF 1.2 refuses sizes "
    "that aren't positive (urdfdom#242) isn't done, its words are in no source at hand; the words about its limits are those of "
    "a fork of the author of #212",
    "geometry_msgs/msg/VelocityStamped": "is in branch humble by a later update and not in the first Humble: it is there",
    "columns of a .db3 file": "are those of rosbag2's newer schema in every distribution, which Humble reads by name",
    "launch files of other names in Humble": "are found under them by ros2 launch; `ls` of share shows the later names",
    "launch and launch_ros": "have what came with Iron (launch#649, #652; launch_ros#311, #317, #325) in Humble too",
    "modules of rclpy": "that Humble lacks (event_handler, parameter_client, type_hash) can be imported there too, and "
    "endpoint_info before Lyrical",
    "words of help": "of options that all have are Kilted's",
    "ros2 doctor --exclude-packages": "is there in Humble too",
    "rqt_robot_steering before Lyrical": "its restore_settings is known from #18 only, not after #23 (1.0.2 to 3.0.0): as in #18",
    "depth of a Humble turtlesim's topics": "7 as later (ros_tutorials#161) in place of 1: no tool shows it",
}
"""What no source could settle, or is known and not told apart -> what is done."""


def value(key: str) -> Any:
    """Return the value of a row of `VALUES` in this process's distribution."""
    row = VALUES[key][0]
    return next(row[name] for name in reversed(NAMES[: NAMES.index(current()) + 1]) if name in row)


def has_package(name: str) -> bool:
    """Return whether one of our packages is in this distribution."""
    return name not in PACKAGES or current() in PACKAGES[name][0]


def has_interface(name: str) -> bool:
    """Return whether an interface ('std_msgs/msg/String') of our packages is in this distribution."""
    package = name.partition("/")[0]
    rows = (INTERFACES.get(name), INTERFACES.get(package))
    return has_package(package) and all(current() in row[0] for row in rows if row is not None)


def path_of(interface: str, share: str) -> str:
    """Return the file with the text of an interface of our packages, which are in `share`."""
    package, kind, name = interface.split("/")
    folder = os.path.join(_SHARES, TEXTS[interface][0][0]) if _has_own_text(interface) else share
    return os.path.join(folder, package, kind, f"{name}.{kind}")


def lacking(module: str) -> list[str]:
    """Return the names of a module of rclpy or launch that this distribution lacks, like 'Node.wait_for_node'."""
    mine = current()
    table = LAUNCH if module.startswith("launch") else RCLPY
    return [
        key.partition(":")[2] for key, (there, _) in table.items() if mine not in there and key.startswith(f"{module}:")
    ]


def in_launch(key: str) -> bool:
    """Return whether launch has a name, an action or a substitution here, like 'action bool_arg'."""
    return key not in LAUNCH or current() in LAUNCH[key][0]


def has_verb(words: str) -> bool:
    """Return whether `ros2` has a verb here, like 'service echo'."""
    return words not in VERBS or current() in VERBS[words][0]


def has_executable(package: str, name: str) -> bool:
    """Return whether an executable of one of our packages is in this distribution."""
    row = EXECUTABLES.get(f"{package} {name}")
    return row is None or current() in row[0]


def launch_file(package: str, file: str) -> str:
    """Return the name that a launch file of a package has in this distribution; '' if it is not in this one."""
    row = LAUNCH_FILES.get(f"{package} {file}")
    return row[0] if row is not None and current() == "humble" else file


def launch_file_at(path: str) -> str:
    """Return the file to read for the path of a launch file as this distribution has it; any other path as it is."""
    if current() != "humble":
        return path
    folder, name = os.path.split(path)
    package = os.path.realpath(folder).removeprefix(_SHARE + os.sep).partition(os.sep)[0]
    ours = (
        key.partition(" ")[2] for key, (old, _) in LAUNCH_FILES.items() if old == name and key.startswith(f"{package} ")
    )
    return next((os.path.join(folder, file) for file in ours), path)


def lacking_options(words: str) -> tuple[str, ...]:
    """Return the long options that a verb of `ros2` lacks here."""
    mine = current()
    rows = (row for key, row in OPTIONS.items() if key.partition(" since ")[0] == words)
    return tuple(option for options, there, _ in rows if mine not in there for option in options)


def retold(text: str) -> str:
    """Return a text written for the usual distribution (a lesson, a card) as it is for this one.

    The names of the two change places, so that what is a wrong name in the text stays one; turtlesim's types get their package.
    """
    mine = current()
    if mine == DEFAULT:
        return text
    import re

    swapped = {DEFAULT: mine, mine: DEFAULT}
    text = re.sub(rf"\b({DEFAULT}|{mine})\b", lambda found: swapped[found[1]], text)
    return re.sub(r"\bturtlesim(?=[./](?:msg|srv|action)\b)", value("turtlesim.interfaces"), text)


def own_texts(package: str) -> list[str]:
    """Return 'msg/Log'-like names of the interfaces of a package that have another text in this distribution, or only here."""
    return [name.partition("/")[2] for name in TEXTS if name.startswith(f"{package}/") and _has_own_text(name)]


def _has_own_text(interface: str) -> bool:
    return interface in TEXTS and current() in TEXTS[interface][0]
