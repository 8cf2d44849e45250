"""`day6-tui launch-plan`: what a launch would start, told without starting it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros.ros2.launch._plan import Facts, plan_of
from day6_core.ros.ros2.launch._plan_text import WIDTH, lines_of
from day6_core.width import text_width

HEAD = """
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import *
from launch_ros.parameter_descriptions import *
def talker(**more):
    return Node(package="demo_nodes_py", executable="talker", **more)
def generate_launch_description():
    return LaunchDescription(["""


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def planned(text: str, **arguments: str) -> Facts:
    """The plan of a launch file with these actions."""
    Path("a.launch.py").write_text(f"{HEAD}{text}])\n", encoding="utf-8")
    return plan_of("a.launch.py", list(arguments.items()))


def items(text: str, **arguments: str) -> list[Facts]:
    plan = planned(text, **arguments)
    assert plan["error"] == ""
    found: list[Facts] = plan["items"]
    return found


def read(plan: Facts, language: str = "en") -> str:
    lines = list(lines_of(plan, language))
    assert all(text_width(line) <= WIDTH for line in lines)
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("action", "name"),
    [
        ("talker(name='a')", "/a"),
        ("talker(name='a', namespace='n')", "/n/a"),
        ("PushROSNamespace('p'), talker(name='a', namespace='n')", "/p/n/a"),
        ("PushROSNamespace('p'), talker(name='a', namespace='/n')", "/n/a"),
        ("talker(name='a', remappings=[('__node', 'b'), ('__ns', '/m')])", "/m/a"),
        ("talker(remappings=[('__node', 'b'), ('__ns', '/m')])", "/m/b"),
        ("talker(name='a', namespace='n', arguments=['--ros-args', '-r', '__node:=b', '-r', '__ns:=/m'])", "/m/b"),
        ("talker(namespace='n')", ""),
    ],
)
def test_the_name_is_the_one_that_the_program_gets(action: str, name: str) -> None:
    (node,) = items(action)
    assert (node["kind"], node["name"]) == ("node", name)
    assert (node["package"], node["executable"]) == ("demo_nodes_py", "talker")


def test_each_parameter_is_told_with_the_file_that_it_is_from() -> None:
    Path("p.yaml").write_text(
        "/**: {ros__parameters: {rate: 1, depth: 2, who: $(var who)}}\nother: {ros__parameters: {x: 1}}\n"
    )
    (node,) = items(
        "SetLaunchConfiguration('who', 'me'), SetParameter('everywhere', True),"
        "talker(name='a', parameters=[ParameterFile('p.yaml', allow_substs=True), {'rate': 5, 'list': [1, 2]}],"
        "ros_arguments=['-p', 'depth:=9', '--log-level', 'debug'], arguments=['-v'], remappings=[('chatter', '/c')])"
    )
    of_name = {each["name"]: (each["value"], each["source"]) for each in node["parameters"]}
    assert of_name == {
        "depth": (2, "p.yaml"),  # what comes later on the command line wins
        "everywhere": (True, ""),
        "rate": (5, ""),
        "who": ("me", "p.yaml"),
        "list": ([1, 2], ""),
    }
    assert node["other_nodes"] == [{"node": "other", "source": "p.yaml"}]
    assert (node["remaps"], node["arguments"]) == (["chatter:=/c"], ["-v"])
    assert node["ros_arguments"] == ["--log-level debug"]


def test_parameters_for_a_name_are_told_where_the_program_chooses_it() -> None:
    Path("p.yaml").write_text("talker: {ros__parameters: {x: 1}}\n")
    (node,) = items("talker(parameters=['p.yaml'])")
    assert (node["parameters"], node["if_named"]) == ([], [{"node": "talker", "source": "p.yaml"}])


def test_a_bad_command_line_is_told_as_refused() -> None:
    (node,) = items("talker(name='a', ros_arguments=['--no-such'])")
    assert "--no-such" in node["refused"] and "refuses" in read(planned("talker(ros_arguments=['--no-such'])"))


def test_what_conditions_keep_out_is_told_with_the_reason() -> None:
    plan = planned(
        "DeclareLaunchArgument('rviz', default_value='false'),"
        "GroupAction([talker(), ExecuteProcess(cmd=['echo', 'a'])], condition=IfCondition(LaunchConfiguration('rviz'))),"
        "talker(name='b', condition=UnlessCondition('1')),"
    )
    assert [item["entities"] for item in plan["items"]] == [
        ["demo_nodes_py talker", "echo a"],
        ["demo_nodes_py talker"],
    ]
    assert "left out: demo_nodes_py talker, echo a (if LaunchConfig('rviz'), which is\n" in read(plan)
    (node,) = items("talker(name='b', condition=UnlessCondition('0'))")
    assert node["name"] == "/b"


def test_arguments_are_told_with_where_their_values_are_from() -> None:
    Path("b.launch.xml").write_text('<launch><arg name="c" default="1"/><arg name="d" default="2"/></launch>')
    plan = planned(
        "DeclareLaunchArgument('a', default_value='1'), DeclareLaunchArgument('b', default_value='1'),"
        "IncludeLaunchDescription('b.launch.xml', launch_arguments=[('c', '7')])",
        b="5",
    )
    told = [(each["name"], each["value"], each["origin"]) for each in plan["arguments"]]
    assert told == [("a", "1", "default"), ("b", "5", "given"), ("c", "7", "launch_file"), ("d", "2", "default")]
    assert [Path(each).name for each in plan["includes"]] == ["b.launch.xml"]
    assert "This launch starts nothing." in read(plan)


def test_functions_are_called_and_what_they_return_is_told() -> None:
    (node,) = items(
        "OpaqueFunction(function=lambda context: [talker(name=LaunchConfiguration('who').perform(context))])", who="me"
    )
    assert node["name"] == "/me"


def test_states_and_prefixes_of_nodes_are_told() -> None:
    node, transitions, behind, event = items("""
        LifecycleNode(package="lifecycle", executable="lifecycle_talker", name="t", namespace="", autostart=True),
        LifecycleTransition(lifecycle_node_names=["t", "u"], transition_ids=[1, "3"]),
        talker(name="b", prefix="nice -n 5", arguments=["x"]),
        RegisterEventHandler(__import__("launch").EventHandler(matcher=lambda event: True, entities=[EmitEvent(
            event=__import__("launch").events.Shutdown(reason="r"))])),
    """)
    assert (node["lifecycle"], behind["prefix"], behind["arguments"]) == ("active", ["nice", "-n", "5"], ["x"])
    assert (transitions["nodes"], transitions["steps"]) == (["t", "u"], ["configure", "activate"])
    assert (event["when"], event["reason"]) == ([{"wait": "event", "text": ""}], "r")


WAITING = """
    SetEnvironmentVariable("COLOUR", "red"),
    GroupAction([PushROSNamespace("scoped"), TimerAction(period=1.5, actions=[talker(name="later")])]),
    first := ExecuteProcess(cmd=["echo", "a"], name="first", on_exit=[talker(name="after")]),
    RegisterEventHandler(OnProcessStart(target_action=first, on_start=[talker(name="beside")])),
    RegisterEventHandler(OnProcessIO(on_stdout=lambda event: None)),
    RegisterEventHandler(OnProcessExit(on_exit=[OpaqueFunction(function=lambda context: 1 / 0)])),
    RegisterEventHandler(OnShutdown(on_shutdown=[ExecuteProcess(cmd=["echo", LocalSubstitution("event.reason")])])),
    gone := RegisterEventHandler(OnShutdown(on_shutdown=[talker(name="never")])),
    UnregisterEventHandler(gone.event_handler),
    ExecuteProcess(cmd=["echo", "b"], name="last", on_exit=Shutdown(reason="done"), respawn=True),
"""


def test_what_waits_is_told_with_what_it_waits_for() -> None:
    def waits(item: Facts) -> list[Any]:
        return [(each["wait"], each.get("of", each.get("seconds"))) for each in item.get("when", [])]

    plan = planned(WAITING)
    found = [
        (waits(item), item.get("name") or item.get("why") or item.get("event") or item["kind"])
        for item in plan["items"]
    ]
    assert found == [
        ([], "process"),
        ([], "process"),
        ([("timer", 1.5)], "/later"),  # the namespace of the group is gone by then
        ([("exit", found[3][0][0][1])], "/after"),
        ([("start", found[3][0][0][1])], "/beside"),
        ([("output", None)], "function"),
        ([("exit", None)], "function"),
        ([("shutdown", None)], "error"),
        ([("exit", found[8][0][0][1])], "launch.events.Shutdown"),
    ]
    text = read(plan)
    for line in (
        "1.5 s later",
        "    variable: COLOUR=red",
        "    is started again when it ends",
        "  the launch ends (done)",
    ):
        assert f"\n{line}\n" in f"{text}\n"
    assert "1.5 秒后" in read(plan, "zh")


def test_what_starts_itself_again_comes_to_an_end() -> None:
    Path("again.launch.xml").write_text('<launch><timer period="1"><include file="again.launch.xml"/></timer></launch>')
    plan = plan_of("again.launch.xml", [])
    assert [item["why"] for item in plan["items"]] == ["endless"]


def test_components_are_told_within_their_container() -> None:
    Path("p.yaml").write_text("/n/t: {ros__parameters: {x: 1}}\n")
    container, left_out, loaded = items("""
        ComposableNodeContainer(name="box", namespace="", package="rclcpp_components", executable="component_container",
            composable_node_descriptions=[
                ComposableNode(package="composition", plugin="composition::Talker", name="t", namespace="n",
                    parameters=["p.yaml", {"y": [1.5]}], remappings=[("chatter", "/c")]),
                ComposableNode(package="composition", plugin="composition::Listener", condition=IfCondition("0"))]),
        LoadComposableNodes(target_container="/box", composable_node_descriptions=[
            ComposableNode(package="composition", plugin="composition::Server")])""")
    (component,) = container["components"]
    assert (container["name"], component["name"], component["remaps"]) == ("/box", "/n/t", ["chatter:=/c"])
    assert [(each["name"], each["value"], each["source"]) for each in component["parameters"]] == [
        ("x", 1, "p.yaml"),
        ("y", [1.5], ""),
    ]
    assert left_out["entities"] == ["composition::Listener"]
    assert (loaded["container"], loaded["components"][0]["plugin"]) == ("/box", "composition::Server")


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("talker(), DeclareLaunchArgument('must')", "missing required argument 'must'"),
        ("Node(package='demo_nodes_py', executable='nothing')", "executable 'nothing' not found"),
        ("Node(package='no_such_package', executable='a')", "package 'no_such_package' not found"),
        ("OpaqueFunction(function=lambda context: 1 / 0)", "ZeroDivisionError"),
    ],
)
def test_what_ends_a_launch_is_told(text: str, error: str) -> None:
    plan = planned(text)
    assert error in plan["error"]
    assert "The launch ends before anything starts" in read(plan)


@pytest.mark.process
def test_the_command_prints_the_plan_and_starts_nothing(here: Path) -> None:
    (here / "a.launch.py").write_text(
        f"print('noise')\n{HEAD}ExecuteProcess(cmd=['touch', LaunchConfiguration('file')], name='p')])\n"
    )
    env = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "HOME": str(here), "DAY6_LANG": "en"}
    command = [sys.executable, "-m", "day6_tui", "launch-plan"]

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [*command, *words], env=env, capture_output=True, text=True, encoding="utf-8", check=False
        )

    done = run("a.launch.py", "file:=started", "--json")
    (process,) = json.loads(done.stdout)["items"]
    assert (done.returncode, process["command"], done.stderr) == (0, ["touch", "started"], "noise\n")
    done = run("a.launch.py")
    assert (done.returncode, "Traceback" in done.stderr, "'file'" in done.stdout) == (1, False, True)
    done = run("no_such_package", "a.launch.py")
    assert done.returncode == 1 and "Package 'no_such_package' not found" in done.stderr
    assert sorted(os.listdir(here)) == ["a.launch.py"]
