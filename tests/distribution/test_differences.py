"""Each row of the tables as a user meets it, in every distribution."""

from __future__ import annotations

import ast
import inspect
import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from rosbags.typesys import Stores, get_typestore

from day6_core.ros import differences
from day6_core.ros.differences import (
    EXECUTABLES,
    INTERFACES,
    LAUNCH,
    LAUNCH_FILES,
    OPTIONS,
    PACKAGES,
    RCLPY,
    TEXTS,
    VALUES,
    VERBS,
)
from day6_core.ros.distribution import NAMES
from tests.ros2.ros2_machine import Machine
from tests.support.other_distribution import DECIDED_AT_IMPORT
from tests.support.short_folder import make_short_folder
from tests.support.waiting import until

from .command import day6, sections, started, wait_for

ASKING = {name for name, _ in inspect.getmembers(differences, inspect.isfunction) if not name.startswith("_")}
"""What `differences` is asked with."""

LAUNCHED = (
    "composition composition_demo_launch.py",
    "lifecycle lifecycle_demo_launch.py",
    "demo_nodes_cpp talker_listener_launch.yaml",
)
"""Some of LAUNCH_FILES."""

RELEASES = {
    "humble": Stores.ROS2_HUMBLE,
    "jazzy": Stores.ROS2_JAZZY,
    "kilted": Stores.ROS2_KILTED,
    "lyrical": Stores.ROS2_LYRICAL,
    "rolling": Stores.ROS2_LYRICAL,
}
"""What the authors of rosbags collected from each release."""

PLAYED = NAMES[:-1]
"""Rolling has what Lyrical has: `test_rolling_goes_on_from_lyrical`."""

NAMED = {**RCLPY, **{key: row for key, row in LAUNCH.items() if ":" in key}}

PROGRAM = """
import json, sys, warnings
from importlib import import_module
import rclpy
from rclpy.node import Node
from rclpy.qos import HistoryPolicy
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from lifecycle_msgs.msg import TransitionEvent
from rclpy.lifecycle import LifecycleNode
import example_interfaces.srv as srv
from example_interfaces.srv import AddTwoInts

def found(name):
    module, _, attributes = name.partition(":")
    place = import_module(module)
    for each in attributes.split("."):
        if not hasattr(place, each):
            return False
        place = getattr(place, each)
    return True

def said(call):
    try:
        call()
    except Exception as error:
        return f"{type(error).__name__}: {error}"

def set_to(value):
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        joints = JointState(name=value)
    try:
        joints.name = 5
    except AssertionError as error:
        return [f"{each.category.__name__}: {each.message}" for each in told], type(joints.name).__name__, str(error)

def transition():
    heard = []
    life = LifecycleNode("life")
    node.create_subscription(TransitionEvent, "/life/transition_event", heard.append, 10)
    life.trigger_configure()
    while not heard:
        rclpy.spin_once(node)
    fields = heard[0].get_fields_and_field_types()
    stamp = heard[0].stamp.sec if "stamp" in fields else heard[0].timestamp
    life.destroy_node()
    return list(fields)[0], stamp > 0, heard[0].transition.id, heard[0].transition.label

manager = rclpy.init()
node = Node("asked")
print(json.dumps({
    "rclpy": {name: found(name) for name in json.loads(sys.argv[1])},
    "manager": manager is not None,
    "services": sorted(name for name, _ in node.get_service_names_and_types()),
    "wrong": said(lambda: String(data=5)),
    "unchecked": said(lambda: String(data=5, check_fields=False)),
    "slots": list(String.__slots__),
    "set": set_to({"a"}),
    "tuple": set_to(("a",)),
    "alone": said(lambda: node.declare_parameters("", [("alone",)])),
    "old_policy": said(lambda: HistoryPolicy.RMW_QOS_POLICY_HISTORY_KEEP_LAST),
    "qos_event": said(lambda: import_module("rclpy.qos_event")),
    "event": hasattr(AddTwoInts, "Event") and "AddTwoInts_Event" in srv.__all__,
    "transition": transition(),
}))
"""

WRITER = """\
import rosbag2_py
from rclpy.serialization import serialize_message
from std_msgs.msg import String

def write(**ids):
    writer = rosbag2_py.SequentialWriter()
    storage = rosbag2_py._storage.StorageOptions(uri="written", storage_id="sqlite3")
    writer.open(storage, rosbag2_py._storage.ConverterOptions("", ""))
    writer.create_topic(
        rosbag2_py._storage.TopicMetadata(name="chatter", type="std_msgs/msg/String", serialization_format="cdr", **ids))
    writer.write("chatter", serialize_message(String(data="x")), 1)

try:
    write()
except TypeError:
    print("an id is needed")
    import shutil
    shutil.rmtree("written", ignore_errors=True)
    write(id=0)
"""
"""In the shape of the tutorial about bags from Python."""

PARTS = {
    "turtlesim": "ros2 run turtlesim turtlesim_node > /dev/null 2>&1 & "
    "until ros2 topic list | grep -q pose; do sleep 0.05; done; "
    "ros2 topic type /turtle1/pose; ros2 service type /spawn; ros2 topic info -v /turtle1/pose; ros2 service list; "
    "ros2 param list /turtlesim; kill %1; wait",
    "parameters": "ros2 run demo_nodes_cpp parameter_blackboard > /dev/null 2>&1 & "
    "ros2 run demo_nodes_cpp talker > /dev/null 2>&1 & "
    "until ros2 node list --count-nodes | grep -q 2; do sleep 0.05; done; "
    "ros2 param set /parameter_blackboard numbers '[1, 2]'; ros2 param set /parameter_blackboard flag true; "
    "ros2 param get /parameter_blackboard numbers; ros2 param get /parameter_blackboard numbers flag; "
    "ros2 param get use_sim_time; ros2 param get --hide-type use_sim_time; "
    "ros2 param get /talker none some; ros2 param get /talker none; "
    "ros2 param set /parameter_blackboard numbers '[4]' flag false; ros2 param set /parameter_blackboard flag; "
    "ros2 param set /parameter_blackboard flag true; "
    "ros2 param set --atomic /parameter_blackboard flag false numbers '[5]'; "
    "ros2 param list --service-timeout 3 --filter flag /parameter_blackboard; "
    "mkdir kept; ros2 param dump /parameter_blackboard --print --output-dir kept; grep -A1 numbers kept/*; "
    "ros2 param dump /parameter_blackboard --output-dir kept; kill %1; kill %2; wait",
    "service details": "ros2 run demo_nodes_cpp add_two_ints_server > /dev/null 2>&1 & "
    "until ros2 service list | grep -q two_ints; do sleep 0.05; done; ros2 service info -v /add_two_ints; kill %1; wait",
    "build": "mkdir -p ws/src; cd ws/src; ros2 pkg create --build-type ament_python made > /dev/null 2>&1; cd ..; "
    "colcon build 2>&1; cd ..",
    "licence": "ros2 pkg create --build-type ament_cmake unlicensed",
    "segments": "echo \"<robot name='r'><link name='b'/><link name='a'/><joint name='j' type='fixed'><parent link='b'/>"
    "<child link='a'/></joint></robot>\" > r.urdf; ros2 run robot_state_publisher robot_state_publisher r.urdf > said.txt 2>&1 & "
    "until ros2 topic list | grep -q tf_static; do sleep 0.05; done; kill -INT %1; wait; cat said.txt",
    "turtlesim module": "python3 -c 'from turtlesim.srv import Spawn'",
    "turtlesim_msgs module": "python3 -c 'from turtlesim_msgs.srv import Spawn'",
    "action tutorial": "ros2 run action_tutorials_py fibonacci_action_server > /dev/null 2>&1 & "
    "until ros2 action list | grep -q fibonacci; do sleep 0.05; done; ros2 action info -t /fibonacci; kill %1; wait",
    "launch files": "; ".join(
        f"ros2 launch {key.split()[0]} {file} -p"
        for key in LAUNCHED
        for file in (key.split()[1], LAUNCH_FILES[key][0])
        if file
    ),
    "included": 'echo \'<launch><include file="$(find-pkg-share demo_nodes_cpp)/launch/topics/talker_listener.launch.py"/>'
    "</launch>' > in.launch.xml; ros2 launch in.launch.xml > launched.txt 2>&1 & "
    "until grep -q 'talker-1\\|No such file' launched.txt 2> /dev/null; do sleep 0.05; done; "
    "kill -INT %1; wait; cat launched.txt",
    "same names": "ros2 run demo_nodes_py talker > /dev/null 2>&1 & ros2 run demo_nodes_py talker > /dev/null 2>&1 & "
    "until ros2 node list --count-nodes | grep -q 2; do sleep 0.05; done; ros2 node list; kill %1; kill %2; wait",
    "executables": "ros2 pkg executables",
    "packages": "ros2 pkg list",
    "interfaces": "ros2 interface list",
    "action": "ros2 action",
    "bag": "ros2 bag",
    "service": "ros2 service",
    "record": "test $ROS_DISTRO = lyrical && NAMED=--topics; ros2 run demo_nodes_py talker > /dev/null 2>&1 & "
    "until ros2 topic list | grep -q chatter; do sleep 0.05; done; "
    "ros2 bag record -o mine $NAMED /chatter > said.txt 2>&1 & until grep -q Recording said.txt; do sleep 0.05; done; "
    "until ros2 service list | grep rosbag2_recorder/describe; do sleep 0.05; done; ros2 service list; "
    "kill -INT %2; wait %2; kill %1; wait; cat said.txt; ls mine; cat mine/metadata.yaml",
    "info": "ros2 bag info mine",
    "reindex": "rm mine/metadata.yaml; ros2 bag reindex mine 2>&1 | tail -1; ros2 bag record /chatter > refused.txt 2>&1 & "
    "until grep -q 'arguments\\|Listening' refused.txt; do sleep 0.05; done; kill -INT %1; wait; cat refused.txt; "
    "ros2 bag play mine -s mcap > stored.txt 2>&1; cat stored.txt",
    "bandwidth": "ros2 run demo_nodes_py talker > /dev/null 2>&1 & until ros2 topic list | grep -q chatter; do sleep 0.05; done; "
    "N=$(test $ROS_DISTRO = lyrical && echo 6 || echo 60); { ros2 topic bw /chatter /rosout 2>&1 | head -$N; "
    "ros2 topic bw --all 2>&1 | head -$N; ros2 topic hz -a 2>&1 | head -$N; } "
    "| tr = _; "
    "kill %1; wait",
    "play": "ros2 bag play -r 100 mine 2>&1 | cat",
    "write": "python3 writer.py; ros2 bag info written",
    "capsule": "check_urdf capsule.urdf 2>&1",
}

CAPSULE = """\
<robot name="pill" version="1.1">
  <link name="a">
    <visual><origin quat_xyzw="0 0 0 1"/><geometry><capsule radius="0.1" length="0.4"/></geometry></visual>
  </link>
</robot>
"""


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, str]]:
    """What each distribution printed, part by part."""
    found = {}
    for name in PLAYED:
        home = tmp_path_factory.mktemp(name)
        (home / "program.py").write_text(PROGRAM, encoding="utf-8")
        (home / "writer.py").write_text(WRITER, encoding="utf-8")
        (home / "capsule.urdf").write_text(CAPSULE, encoding="utf-8")
        (home / "names.json").write_text(json.dumps(list(NAMED)), encoding="utf-8")
        parts = {"home": f"cd {home}", **PARTS, "rclpy": 'python3 program.py "$(cat names.json)"'}
        found[name] = sections(home, parts, ROS_DISTRO=name)
    return found


@pytest.fixture
def asked(played: dict[str, dict[str, str]], name: str) -> dict[str, object]:
    """What the program of a user found in a distribution."""
    line = next(line for line in played[name]["rclpy"].splitlines() if line.startswith("{"))  # between warnings
    answer: dict[str, object] = json.loads(line)
    return answer


def test_every_row_names_its_source() -> None:
    for table in (VALUES, PACKAGES, INTERFACES, TEXTS, RCLPY, LAUNCH, LAUNCH_FILES, EXECUTABLES, VERBS, OPTIONS):
        for key, row in table.items():
            assert len(row[-1]) > 10 and (any(mark in row[-1] for mark in ("/", "REP", "rosbags"))), key


def test_rolling_goes_on_from_lyrical() -> None:
    assert not [key for key, (row, _) in VALUES.items() if "rolling" in row]
    for table in (PACKAGES, INTERFACES, TEXTS, RCLPY, LAUNCH, EXECUTABLES, VERBS, OPTIONS):
        assert not [key for key, row in table.items() if ("lyrical" in row[-2]) != ("rolling" in row[-2])]


@pytest.mark.parametrize("name", NAMES)
def test_the_messages_are_those_of_the_release(
    name: str, monkeypatch: pytest.MonkeyPatch, in_distribution: Callable[[str], None]
) -> None:
    """Each message with its fields and constants, compared with another collection of them."""
    from day6_core.interfaces import registry

    in_distribution(name)
    monkeypatch.setattr(registry, "_structures", {})
    release = get_typestore(RELEASES[name]).fielddefs
    beside = ("example_interfaces/", "test_msgs/", "turtlesim", "rmw_dds_common/")
    theirs = {each for each in release if "/msg/" in each and not each.startswith(beside)}
    of_ros = {each.partition("/")[0] for store in RELEASES.values() for each in get_typestore(store).fielddefs}
    packages = of_ros.intersection(registry.packages())
    ours = {f"{package}/{each}" for package in packages for each in registry.interface_names(package, "msg")}
    ours = {each for each in ours if not each.startswith(beside)}
    if name == "humble":  # came into the branch later, with common_interfaces 4.2.4
        ours.remove("geometry_msgs/msg/VelocityStamped")
    if name == "jazzy":  # see KEPT
        ours.remove("nav_msgs/msg/Goals")
    assert ours == theirs
    for each in sorted(ours):
        structure = registry.structure(each)
        constants, fields = release[each]
        names = [field for field, _ in fields if field != "structure_needs_at_least_one_member"]
        assert [field.name for field in structure.fields] == names, each
        assert {one.name for one in structure.constants} == {one for one, *_ in constants}, each


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_the_lists_have_what_there_is(played: dict[str, dict[str, str]], name: str) -> None:
    packages, interfaces = played[name]["packages"].split(), played[name]["interfaces"].split()
    for package, (there, _) in PACKAGES.items():
        assert (package in packages) == (name in there), package
    for interface, (there, _) in INTERFACES.items():
        assert any(each.startswith(f"{interface}/") or each == interface for each in interfaces) == (name in there), (
            interface
        )
    for interface, (there, _) in TEXTS.items():
        if interface.startswith(("rosgraph_msgs", "nav_msgs")):
            assert (interface in interfaces) == (name in there), interface
    assert "turtlesim" in packages
    executables = played[name]["executables"].splitlines()
    for executable, (there, _) in EXECUTABLES.items():
        assert (executable in executables) == (name in there), executable


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_turtlesim_has_the_types_of_its_distribution(played: dict[str, dict[str, str]], name: str) -> None:
    package = "turtlesim" if name in ("humble", "jazzy") else "turtlesim_msgs"
    said = played[name]["turtlesim"].splitlines()
    assert said[:2] == [f"{package}/msg/Pose", f"{package}/srv/Spawn"]
    for module in ("turtlesim", "turtlesim_msgs"):
        lines = played[name][f"{module} module"].splitlines()
        wanted = [] if module == package else [f"ModuleNotFoundError: No module named '{module}'"]
        assert lines[-1:] == wanted and len(lines) in (0, 3)  # the traceback names no file of ours


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_hashes_and_descriptions_of_types_came_after_humble(played: dict[str, dict[str, str]], name: str) -> None:
    said = played[name]["turtlesim"]
    assert ("Topic type hash: RIHS01_" in said) == ("/turtlesim/get_type_description" in said) == (name != "humble")
    assert (("  holonomic" in said), ("  start_type_description_service" in said)) == (
        name != "humble",
        name != "humble",
    )


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_rclpy_and_launch_have_the_names_of_its_distribution(asked: dict[str, object], name: str) -> None:
    assert asked["rclpy"] == {key: name in there for key, (there, _) in NAMED.items()}
    assert asked["manager"] == asked["event"] == (name != "humble")
    assert ("/asked/get_type_description" in str(asked["services"])) == (name != "humble")


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_humble_always_checks_fields(asked: dict[str, object], name: str) -> None:
    assert asked["wrong"] == "AssertionError: The 'data' field must be of type 'str'"
    refused = "AssertionError: Invalid arguments passed to constructor: check_fields"
    assert asked["unchecked"] == (refused if name == "humble" else None)
    assert asked["slots"] == (["_data"] if name == "humble" else ["_data", "_check_fields"])


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_urdf_1_1_is_read_from_lyrical_on(played: dict[str, dict[str, str]], name: str) -> None:
    said = played[name]["capsule"]
    refused = "Invalid 'version' specified; only version 1.0 is currently supported"
    assert (refused in said, "robot name is: pill" in said) == (name != "lyrical", name == "lyrical")


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_sets_for_arrays_are_deprecated_in_lyrical_and_tuples_become_lists(asked: dict[str, object], name: str) -> None:
    old = name != "lyrical"
    refused = f"The 'name' field must be {'a set or ' if old else ''}sequence and each value of type 'str'"
    warning = "Using set or subclass of set is deprecated, please use a subclass of collections.abc.Sequence like list"
    assert asked["set"] == [[] if old else [f"DeprecationWarning: {warning}"], "set" if old else "list", refused]
    assert asked["tuple"] == [[], "tuple" if old else "list", refused]


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_what_was_deprecated_is_gone_in_lyrical(
    played: dict[str, dict[str, str]], asked: dict[str, object], name: str
) -> None:
    gone = name == "lyrical"
    assert str(asked["alone"]).startswith("TypeError: when declaring parameter named 'alone', ") == gone
    assert str(asked["old_policy"]).startswith("AttributeError: ") == gone
    assert asked["qos_event"] == ("ModuleNotFoundError: No module named 'rclpy.qos_event'" if gone else None)
    assert ("Unknown distribution option: 'tests_require'" in played[name]["build"]) == gone
    package = "example_interfaces" if gone else "std_msgs"
    assert f"Topic: /chatter | Type: {package}/msg/String | " in played[name]["info"]


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_a_bag_can_be_played(played: dict[str, dict[str, str]], name: str) -> None:
    said, humble = played[name]["play"], name == "humble"
    assert "[rosbag2_player]: Set rate to 100" in said
    assert ("Playback until timestamp: -1" in said) != humble
    assert ("[rosbag2_storage]: Opened database 'mine/mine_0.db3' for READ_ONLY." in said) == humble


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_info_tells_of_services_since_jazzy_and_of_actions_since_kilted(
    played: dict[str, dict[str, str]], name: str
) -> None:
    titles = [line.partition(":")[0] for line in played[name]["info"].splitlines() if line[:1].strip()]
    later = {"ROS Distro", "Service information"}
    of_actions = {"Services", "Actions", "Action information"}
    assert {*titles} == {
        "Files", "Bag size", "Storage id", "Duration", "Start", "End", "Messages", "Topic information",
        *(() if name == "humble" else later),
        *({"humble": (), "jazzy": {"Service"}}.get(name, of_actions)),
    }  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_humble_has_no_progress_bar(name: str, in_distribution: Callable[[str], None]) -> None:
    from argparse import ArgumentParser

    from day6_core.ros.ros2.bag import play

    in_distribution(name)
    play.add_arguments(parser := ArgumentParser())
    assert parser.get_default("progress_bar_update_rate") == (0 if name == "humble" else 3)


@pytest.mark.parametrize("name", NAMES)
def test_pausing_and_stepping_are_logged_as_there(name: str, in_distribution: Callable[[str], None]) -> None:
    in_distribution(name)
    said = differences.value("bag.recorder_waits"), differences.value("bag.player_logs_next")
    assert said == (("Waiting for recording", True) if name == "humble" else ("Wait for recording", False))


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_a_program_that_writes_a_bag_gives_topics_an_id_since_jazzy(
    played: dict[str, dict[str, str]], name: str
) -> None:
    said = played[name]["write"]
    assert "Topic: chatter | Type: std_msgs/msg/String | Count: 1" in said
    assert ("an id is needed" in said) == (name != "humble")


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_a_bag_is_of_the_usual_kind(played: dict[str, dict[str, str]], name: str) -> None:
    said, humble = played[name]["record"], name == "humble"
    file = {"humble": r"mine_0\.db3", "lyrical": r"0_mine_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d\.mcap"}.get(
        name, r"mine_0\.mcap"
    )
    assert re.search(rf"^{file}$", said, re.MULTILINE) and re.search(rf'path: "?{file}"?$', said, re.MULTILINE)
    assert f"  version: {5 if humble else 9}\n" in said and (f"ros_distro: {name}" in said) != humble
    assert ('Positional "topics" argument deprecated' in said) == (name == "kilted")
    assert ("/rosbag2_recorder/pause" in said) == ("/rosbag2_recorder/split_bagfile" in said) == (not humble)
    assert ('offered_qos_profiles: "- history: 3\\n' in said) == humble
    assert ("Pausing recording." in said) == (name in ("jazzy", "kilted")) and "Recording stopped" in said
    assert ("[rosbag2_storage]: Opened database 'mine/mine_0.db3' for READ_WRITE." in said) == humble


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_lyrical_has_no_positional_topics_and_no_storage_of_a_bag_to_play(
    played: dict[str, dict[str, str]], name: str
) -> None:
    said, lyrical = played[name]["reindex"], name == "lyrical"
    assert "Reindexing complete." in said
    assert ("unrecognized arguments: /chatter" in said) == ("unrecognized arguments: -s mcap" in said) == lyrical
    assert ("Listening for topics..." in said) != lyrical


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_the_bandwidth_of_several_topics_came_with_lyrical(played: dict[str, dict[str, str]], name: str) -> None:
    said = played[name]["bandwidth"]
    if name != "lyrical":
        assert (
            "unrecognized arguments: /rosout" in said and said.count("the following arguments are required: topic") == 2
        )
        return
    assert said.startswith("Subscribed to [/chatter]\nSubscribed to [/rosout]\n")
    assert " topic     bandwidth   window    mean    min     max \n" + "_" * 53 + "\n/chatter   " in said
    assert re.search(r"^/chatter +\d+ B/s +\d+ +\d+ B +\d+ B +\d+ B *$", said, re.MULTILINE)
    assert re.search(r"^ *topic +rate +min_delta +max_delta +std_dev +window *$", said, re.MULTILINE)


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_the_action_tutorial_and_a_warning_are_those_of_the_distribution(
    played: dict[str, dict[str, str]], name: str
) -> None:
    package = "action_tutorials_interfaces" if name == "humble" else "example_interfaces"
    slashes = "//" if name == "kilted" else "/"
    assert f"    {slashes}fibonacci_action_server [{package}/action/Fibonacci]" in played[name]["action tutorial"]


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_launch_files_have_the_names_of_their_distribution(played: dict[str, dict[str, str]], name: str) -> None:
    said = played[name]["launch files"]
    for key in LAUNCHED:
        for file, there in ((LAUNCH_FILES[key][0], name == "humble"), (key.split()[1], name != "humble")):
            assert not file or (f"file '{file}' was not found" in said) != there, file
    included = played[name]["included"]
    assert ("[talker-1]" in included, "No such file" in included) == (
        (True, False) if name == "humble" else (False, True)
    )
    wrong = "WARNING: Be aware that are nodes in the graph that share an exact name, this can"
    right = "WARNING: Be aware that there are nodes in the graph that share an exact name, which can"
    assert (wrong if name == "humble" else right) in played[name]["same names"]


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_ros2_lists_the_verbs_of_its_distribution(played: dict[str, dict[str, str]], name: str) -> None:
    for words, (there, _) in VERBS.items():
        command, verb = words.split()
        listed = [line.split()[0] for line in played[name][command].splitlines() if line.startswith("  ")]
        assert (verb in listed) == (name in there), words


@pytest.mark.parametrize("words", OPTIONS)
def test_ros2_takes_the_options_of_its_distribution(
    words: str, tmp_path: Path, in_distribution: Callable[[str], None]
) -> None:
    options, there, _ = OPTIONS[words]
    verb, _, first = words.partition(" since ")
    for name in (NAMES[NAMES.index(first) - 1], first) if first else ("humble", "kilted"):
        in_distribution(name)
        text = Machine(tmp_path).ros2(*verb.split(), "--help").stdout
        found = {each.strip(",") for line in text.splitlines() if line.startswith("  -") for each in line.split()}
        assert (found & {*options} == {*options}) if name in there else not found & {*options}, text


@pytest.mark.process
def test_an_option_of_later_is_unknown_in_humble() -> None:
    done = day6("ros2", "topic", "echo", "/a", "std_msgs/msg/Empty", "--timeout", "1", ROS_DISTRO="humble")
    assert done.returncode == 2 and "unrecognized arguments: --timeout" in done.stderr


@pytest.fixture
def one_graph(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the commands of a test meet on a graph of their own."""
    monkeypatch.setenv("DAY6_LINK", "on")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(make_short_folder()))


def echoed(topic: str, name: str) -> subprocess.CompletedProcess[str]:
    """What `ros2 topic echo --once` says of a topic that is there; a command waits for what the others have a second at most."""

    def said() -> subprocess.CompletedProcess[str] | None:
        done = day6("ros2", "topic", "echo", "--once", topic, ROS_DISTRO=name)
        return None if "does not appear to be published yet" in done.stdout + done.stderr else done

    answer = until(said)
    assert answer is not None
    return answer


@pytest.mark.process
@pytest.mark.usefixtures("one_graph")
def test_turtlesim_of_another_distribution_is_seen_and_not_understood() -> None:
    with started("ros2", "run", "turtlesim", "turtlesim_node", ROS_DISTRO="kilted"):
        wait_for("/turtle1/pose [turtlesim_msgs/msg/Pose]", "ros2", "topic", "list", "-t", ROS_DISTRO="jazzy")
        done = echoed("/turtle1/pose", "jazzy")
        assert (done.returncode, done.stderr) == (1, "The message type 'turtlesim_msgs/msg/Pose' is invalid\n")


@pytest.mark.process
@pytest.mark.usefixtures("one_graph")
def test_what_humble_sends_has_no_hash_and_no_newer_one_takes_it() -> None:
    """As with rmw_zenoh, whose keys contain the hash: both see each other, and nothing is delivered."""
    with started("ros2", "run", "demo_nodes_py", "talker", ROS_DISTRO="humble"):
        wait_for("Topic type hash: INVALID", "ros2", "topic", "info", "-v", "/chatter", ROS_DISTRO="jazzy")
        done = day6("ros2", "topic", "echo", "--once", "--timeout", "2", "/chatter", ROS_DISTRO="jazzy")
        assert "data:" not in done.stdout
        assert "data: 'Hello World" in echoed("/chatter", "humble").stdout


LOOKING = """
import rclpy
from example_interfaces.srv import AddTwoInts

rclpy.init()
node = rclpy.create_node("looking")
assert node.create_client(AddTwoInts, "add_two_ints").wait_for_service(60)
for found in node.get_servers_info_by_service("add_two_ints") + node.get_clients_info_by_service("/add_two_ints"):
    print(found.endpoint_type.name, found.node_name, found.service_type, len({*map(tuple, found.endpoint_gids)}))
"""


@pytest.mark.process
@pytest.mark.usefixtures("one_graph")
@pytest.mark.parametrize("name", ["lyrical", "rolling"])
def test_a_node_of_lyrical_knows_the_servers_of_other_programs(name: str, tmp_path: Path) -> None:
    (tmp_path / "looking.py").write_text(LOOKING, encoding="utf-8")
    line = "ros2 run demo_nodes_cpp add_two_ints_server & cd ~; python3 looking.py; kill %1"
    said = day6("exec", "--home", str(tmp_path), "-c", line, ROS_DISTRO=name).stdout.splitlines()
    interface = "example_interfaces/srv/AddTwoInts"
    assert said == [f"SERVER add_two_ints_server {interface} 2", f"CLIENT looking {interface} 2"]


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_several_parameters_came_with_lyrical(played: dict[str, dict[str, str]], name: str) -> None:
    said = played[name]["parameters"].removeprefix("Set parameter successful\n" * 2)
    first = "Integer values are: " + ("array('q', [1, 2])" if name == "humble" else "[1, 2]") + "\n"
    assert said.startswith(first)
    if name != "lyrical":
        assert "unrecognized arguments: flag" in said and "the following arguments are required: parameter_name" in said
        assert "Parameter not set\n" in said
        return
    assert said.startswith(
        f"{first}numbers:\n  {first}flag:\n  Boolean value is: True\n"
        "/parameter_blackboard:\n  Boolean value is: False\n/talker:\n  Boolean value is: False\n"
        "/parameter_blackboard: False\n/talker: False\n"
        "Parameter(s) 'none', 'some' not available on node\nParameter(s) 'none' not available on node\n"
        "numbers: Set parameter successful\nflag: Set parameter successful\n"
        "Parameters must be provided as name/value pairs: name value [name value ...]. Got 1 argument(s).\n"
        "Set parameter successful\nSet parameters atomically successful\n  flag\n"
    )


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_details_of_a_service_came_with_lyrical(played: dict[str, dict[str, str]], name: str) -> None:
    said = played[name]["service details"]
    if name != "lyrical":
        assert ("unrecognized arguments: -v" in said) == (name != "humble")
        return
    gid = r"(?:[0-9a-f]{2}\.){15}0"
    half = "      Reliability: RELIABLE\n      History (Depth): KEEP_LAST (10)\n      Durability: VOLATILE\n"
    half += "      Lifespan: Infinite\n      Deadline: Infinite\n      Liveliness: AUTOMATIC\n"
    half = re.escape(half + "      Liveliness lease duration: Infinite\n")
    assert re.fullmatch(
        "Type: example_interfaces/srv/AddTwoInts\nClients count: 0\nServices count: 1\nNode name: add_two_ints_server\n"
        "Node namespace: /\nService type: example_interfaces/srv/AddTwoInts\nService type hash: RIHS01_[0-9a-f]{64}\n"
        f"Endpoint type: SERVER\nEndpoint count: 2\nGIDs:\n- Request Reader : {gid}4\n- Response Writer : {gid}3\n"
        f"QoS profiles:\n- Request Reader :\n{half}- Response Writer :\n{half}",
        said,
    )


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_humble_can_dump_parameters_into_a_folder(played: dict[str, dict[str, str]], name: str) -> None:
    said = played[name]["parameters"]
    if name != "humble":
        assert "unrecognized arguments: --print --output-dir kept" in said
        return
    file = "kept/parameter_blackboard.yaml"
    assert (
        "WARNING: '--print' is deprecated; this utility prints to stdout by default\n"
        "WARNING: '--output-dir' is deprecated; use redirection to save to a file\n"
        f"Saving to:  {file}\n    numbers:\n    - 1\n"
    ) in said
    assert said.endswith(f"Saving to:  {file}\nFile exists: '{file}'\n")


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_texts_that_humble_has(played: dict[str, dict[str, str]], name: str) -> None:
    humble = name == "humble"
    assert (f"one of the ament license {'identitifers' if humble else 'identifiers'}:") in played[name]["licence"]
    lines = [line.partition("[robot_state_publisher]: ")[2] for line in played[name]["segments"].splitlines()]
    said = [line for line in lines if line and "backwards compatibility" not in line]
    assert said == (["got segment a", "got segment b"] if humble else ["Robot initialized"])


@pytest.mark.process
@pytest.mark.parametrize("name", PLAYED)
def test_a_transition_is_told_with_its_time_since_lyrical(asked: dict[str, object], name: str) -> None:
    new = name == "lyrical"
    assert asked["transition"] == (["stamp", True, 1, "configure"] if new else ["timestamp", False, 0, ""])


def test_what_is_deliberately_another_is_said() -> None:
    assert differences.KEPT and all(differences.KEPT.values())


def _asks_at_import(body: list[ast.stmt]) -> bool:
    """Return whether statements of a module, but not of its functions, call something of `differences`."""
    waiting: list[ast.AST] = list(body)
    while waiting:
        part = waiting.pop()
        if isinstance(part, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            continue
        if isinstance(part, ast.Call) and ast.unparse(part.func).removeprefix("differences.") in ASKING:
            return True
        waiting.extend(ast.iter_child_nodes(part))
    return False


def test_it_is_known_which_modules_keep_the_distribution_they_were_imported_in() -> None:
    core = Path(differences.__file__).parents[1]
    asking = set()
    for path in core.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        if ("differences import" in text or "import differences" in text) and _asks_at_import(ast.parse(text).body):
            root = core / "ros" / "python" if core / "ros" / "python" in path.parents else core.parent
            asking.add(".".join(path.relative_to(root).with_suffix("").parts).removesuffix(".__init__"))
    assert asking == set(DECIDED_AT_IMPORT)
