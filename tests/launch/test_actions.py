"""What a launch does: order, groups, events, processes and their ends."""

from __future__ import annotations

import asyncio
import io
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.actions import (
    AppendEnvironmentVariable,
    DeclareLaunchArgument,
    EmitEvent,
    ExecuteProcess,
    GroupAction,
    IncludeLaunchDescription,
    LogInfo,
    OpaqueCoroutine,
    OpaqueFunction,
    RegisterEventHandler,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
    UnsetLaunchConfiguration,
)
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import (
    OnExecutionComplete,
    OnProcessExit,
    OnProcessIO,
    OnProcessStart,
    OnShutdown,
)
from launch.events import Shutdown as ShutdownEvent
from launch.events import matches_action
from launch.events.process import ShutdownProcess
from launch.frontend.parser import Parser
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import EnvironmentVariable, LaunchConfiguration, LocalSubstitution
from launch_ros.actions import Node
from launch_ros.actions.load_composable_nodes import get_composable_node_load_request
from launch_ros.descriptions import ComposableNode

from rclpy._day6.parameter_files import read_parameter_file
from rclpy.parameter import Parameter

USER = "[INFO] [launch.user]: "


def python(code: str, **options: Any) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", code], name="p", **{"output": "screen", **options})


def said(lines: list[str]) -> list[str]:
    """What LogInfo actions said."""
    return [line.removeprefix(USER) for line in lines if line.startswith(USER)]


def without_numbers(lines: list[str]) -> list[str]:
    return [re.sub(r"\bp-\d+", "p-N", re.sub(r"pid (\d+|\[\d+\])", "pid", line)) for line in lines]


def test_actions_are_executed_in_their_order(launch_these: Callable[..., Any]) -> None:
    result = launch_these(
        LogInfo(msg="one"), OpaqueFunction(function=lambda context: [LogInfo(msg="two")]), LogInfo(msg="3")
    )
    assert (result.status, said(result.lines)) == (0, ["one", "two", "3"])


@pytest.mark.parametrize("name", ["mine", "mine.log"])
def test_the_log_file_has_the_name_that_was_asked_for(
    launch_these: Callable[..., Any], tmp_path: Path, name: str
) -> None:
    assert launch_these(LogInfo(msg="one"), log_file_name=name).status == 0
    (file,) = {
        each.resolve() for each in (tmp_path / "log").glob("*/*")
    }  # `latest` is another name, where there are links
    assert file.name == "mine.log" and "one" in file.read_text(encoding="utf-8")


def test_the_file_of_a_dict_of_parameters_is_the_real_one() -> None:
    """A list in it is tagged, which the programs that read it don't mind."""
    node: Any = Node(executable="x", name="a", namespace="b", parameters=[{"x": {"y": [1, 2]}}])
    node._perform_substitutions(LaunchContext())
    ((path, is_file),) = node._Node__expanded_parameter_arguments
    text = Path(path).read_text(encoding="utf-8")
    assert is_file and yaml.load(text, yaml.FullLoader) == {"/b/a": {"ros__parameters": {"x.y": (1, 2)}}}
    assert read_parameter_file(path) == {"/b/a": {"x.y": [1, 2]}}


def test_conditions_decide_what_is_executed(launch_these: Callable[..., Any]) -> None:
    result = launch_these(
        DeclareLaunchArgument("sim", default_value="true"),
        LogInfo(msg="sim", condition=IfCondition(LaunchConfiguration("sim"))),
        LogInfo(msg="real", condition=UnlessCondition(LaunchConfiguration("sim"))),
    )
    assert said(result.lines) == ["sim"]


TAGS = (
    '<log message="old"/>',
    '<log level="warning" message="warn"/>',
    '<log_debug message="debug"/>',
    '<log_error message="error"/>',
    '<log_info message="info"/>',
    '<bool_arg name="sim" default="False"/>',
    '<bool_arg name="sim" default="maybe"/>',
)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        (
            "kilted",
            [
                "[INFO] [launch.user]: old",
                "Unexpected attribute(s) found in `log`: {'level'}",
                *(f"Unrecognized entity of the type: log_{level}" for level in ("debug", "error", "info")),
                *["Unrecognized entity of the type: bool_arg"] * 2,
            ],
        ),
        (
            "lyrical",
            [
                "[INFO] [launch.user]: old",
                "[WARNING] [launch.user]: warn",
                "",
                "[ERROR] [launch.user]: error",
                "[INFO] [launch.user]: info",
                "",
                "Valid options are: ['true', 'false', 'True', 'False', 'TRUE', 'FALSE']",
            ],
        ),
    ],
)
@pytest.mark.filterwarnings("ignore:The action log now expects")
def test_lyrical_logs_with_levels_and_has_boolean_arguments(
    launch_these: Callable[..., Any], in_distribution: Callable[[str], None], name: str, expected: list[str]
) -> None:
    in_distribution(name)
    for tag, said_there in zip(TAGS, expected, strict=True):
        root, parser = Parser.load(io.StringIO(f"<launch>{tag}</launch>"))
        try:
            lines = launch_these(*parser.parse_description(root).entities).lines
        except (RuntimeError, ValueError) as error:
            lines = [str(error)]
        assert said_there in "".join(lines), tag
        assert said_there or not lines, tag


def test_a_group_keeps_its_settings_to_itself(launch_these: Callable[..., Any]) -> None:
    show = [LaunchConfiguration("c", default="-"), EnvironmentVariable("V_OF_TEST", default_value="-")]
    result = launch_these(
        SetLaunchConfiguration("c", "outside"),
        GroupAction([SetLaunchConfiguration("c", "in"), SetEnvironmentVariable("V_OF_TEST", "in"), LogInfo(msg=show)]),
        LogInfo(msg=show),
        GroupAction([LogInfo(msg=show)], forwarding=False, launch_configurations={"d": "x"}),
        GroupAction([SetLaunchConfiguration("c", "kept")], scoped=False),
        LogInfo(msg=show),
        UnsetLaunchConfiguration("c"),
        LogInfo(msg=show),
    )
    assert said(result.lines) == ["inin", "outside-", "--", "kept-", "--"]


@pytest.mark.process
def test_environment_variables_reach_the_processes(launch_these: Callable[..., Any]) -> None:
    result = launch_these(
        SetEnvironmentVariable("V_OF_TEST", "a"),
        AppendEnvironmentVariable("V_OF_TEST", "b", separator="+"),
        AppendEnvironmentVariable("V_OF_TEST", "0", prepend=True, separator="+"),
        python("import os; print(os.environ['V_OF_TEST'], os.environ['W'])", additional_env={"W": "more"}),
    )
    assert any(line.endswith("] 0+a+b more") for line in result.lines), result.lines


@pytest.mark.process
def test_a_process_is_announced_and_its_end_told(launch_these: Callable[..., Any]) -> None:
    result = launch_these(python("print('out')"), python("import sys; sys.exit(3)"))
    lines = without_numbers(result.lines)
    assert lines.count("[INFO] [p-N]: process started with pid") == 2
    assert "[p-N] out" in lines
    assert "[INFO] [p-N]: process has finished cleanly [pid]" in lines
    assert (
        f"[ERROR] [p-N]: process has died [pid, exit code 3, cmd '{sys.executable} -c import sys; sys.exit(3)']."
        in lines
    )
    assert result.status == 0  # as in real launch: a process that dies is no failure of the launch


@pytest.mark.process
def test_output_goes_where_it_is_wanted(launch_these: Callable[..., Any]) -> None:
    from launch.logging import launch_config

    code = "import sys; print('out'); print('err', file=sys.stderr)"
    shown = {}
    for output in ("screen", "log", "both", {"stdout": "screen", "stderr": "log"}):
        process = ExecuteProcess(cmd=[sys.executable, "-c", code], name="q", output=output)
        lines = launch_these(process).lines
        shown[str(output)] = sorted(line.split()[-1] for line in lines if line.startswith("[q-"))
    assert list(shown.values()) == [["err", "out"], ["err"], ["err", "out"], ["out"]]
    with open(launch_config.get_log_file_path(), encoding="utf-8") as file:
        logged = [line.split()[-1] for line in file if "] out" in line or "] err" in line]
    assert sorted(logged) == ["err", "err", "err", "out", "out"]


def test_an_output_that_does_not_exist_is_an_error(launch_these: Callable[..., Any]) -> None:
    result = launch_these(python("pass", output="scren"))
    assert result.status == 1
    assert 'scren is not a valid standard output config i.e. "screen", "log" or "both"' in result.lines[0]


@pytest.mark.process
def test_output_may_be_kept(launch_these: Callable[..., Any]) -> None:
    process = python("import sys; print('a'); sys.stdout.write('b')", cached_output=True)
    result = launch_these(process)
    assert (process.get_stdout(), process.get_stderr(), process.return_code) == ("a\nb", "", 0)
    assert [line.split("] ")[1] for line in result.lines if line.startswith("[p-")] == ["a", "b"]


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="needs ptys")
def test_a_process_may_be_given_a_terminal(launch_these: Callable[..., Any]) -> None:
    result = launch_these(python("import sys; print(sys.stdout.isatty(), sys.stderr.isatty())", emulate_tty=True))
    assert any(line.endswith("] True True") for line in result.lines), result.lines


@pytest.mark.process
def test_the_shell_runs_a_line(launch_these: Callable[..., Any]) -> None:
    result = launch_these(ExecuteProcess(cmd=["echo one && echo", "two"], shell=True, output="screen", name="p"))
    assert [line for line in without_numbers(result.lines) if line.startswith("[p-N]")] == ["[p-N] one", "[p-N] two"]


@pytest.mark.process
def test_a_program_that_does_not_exist_is_told_and_the_rest_goes_on(launch_these: Callable[..., Any]) -> None:
    result = launch_these(ExecuteProcess(cmd=["no_such_program"]), python("print('still here')"))
    assert any("exception occurred while executing process:" in line for line in result.lines)
    assert "FileNotFoundError: [Errno 2] No such file or directory: 'no_such_program'" in result.lines
    assert any(line.endswith("] still here") for line in result.lines)
    assert result.status == 0


@pytest.mark.process
def test_handlers_follow_a_process_through_its_life(launch_these: Callable[..., Any]) -> None:
    heard: list[bytes] = []
    process = python("import sys; sys.stdout.write('hello\\n'); sys.exit(4)")

    def on_stdout(event: Any) -> LogInfo:
        heard.append(event.text.strip())
        return LogInfo(msg="heard")

    result = launch_these(
        RegisterEventHandler(OnProcessStart(target_action=process, on_start=[LogInfo(msg="started")])),
        RegisterEventHandler(OnProcessIO(target_action=process, on_stdout=on_stdout)),
        RegisterEventHandler(
            OnProcessExit(
                target_action=process,
                on_exit=lambda event, context: [LogInfo(msg=["ended with ", str(event.returncode)])],
            )
        ),
        RegisterEventHandler(OnExecutionComplete(target_action=process, on_completion=[LogInfo(msg="complete")])),
        RegisterEventHandler(
            OnShutdown(on_shutdown=[LogInfo(msg=["the reason is ", LocalSubstitution("event.reason")])])
        ),
        process,
    )
    assert heard == [b"hello"]
    assert said(result.lines) == ["started", "heard", "ended with 4", "complete", "the reason is idle"]


@pytest.mark.process
def test_one_process_may_start_after_the_other(launch_these: Callable[..., Any]) -> None:
    first, second = python("print(1)"), python("print(2)")
    result = launch_these(first, RegisterEventHandler(OnProcessExit(target_action=first, on_exit=second)))
    lines = without_numbers(result.lines)
    assert lines.index("[p-N] 1") < lines.index("[p-N] 2")


def test_a_timer_waits_and_can_be_cancelled(launch_these: Callable[..., Any]) -> None:
    never = TimerAction(period=60.0, actions=[LogInfo(msg="never")])
    result = launch_these(
        never,
        TimerAction(
            period=0.1, actions=[LogInfo(msg="later"), OpaqueFunction(function=lambda context: never.cancel())]
        ),
        LogInfo(msg="first"),
    )
    assert said(result.lines) == ["first", "later"]


@pytest.mark.process
def test_a_shutdown_ends_timers_and_processes(launch_these: Callable[..., Any]) -> None:
    process = python("import time; print('up', flush=True); time.sleep(60)")
    result = launch_these(
        process,
        TimerAction(period=60.0, actions=[LogInfo(msg="never")]),
        RegisterEventHandler(OnProcessIO(on_stdout=lambda event: EmitEvent(event=ShutdownEvent(reason="enough")))),
    )
    assert said(result.lines) == []
    lines = without_numbers(result.lines)
    assert "[INFO] [p-N]: sending signal 'SIGINT' to process[p-N]" in lines
    assert any("process has died [pid, exit code -2," in line for line in lines)


@pytest.mark.process
def test_a_required_process_ends_the_launch(launch_these: Callable[..., Any]) -> None:
    sleeper = python("import time; time.sleep(60)")
    result = launch_these(sleeper, python("import sys; sys.exit(1)", on_exit=Shutdown()))
    lines = without_numbers(result.lines)
    assert "[INFO] [launch]: process[p-N] was required: shutting down launched system" in lines
    assert "[INFO] [p-N]: sending signal 'SIGINT' to process[p-N]" in lines


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGINT")
def test_a_process_that_does_not_listen_is_ended_step_by_step(launch_these: Callable[..., Any]) -> None:
    code = (
        "import signal, time; signal.signal(signal.SIGINT, signal.SIG_IGN); signal.signal(signal.SIGTERM, signal.SIG_IGN)\n"
        "print('up', flush=True); time.sleep(60)"
    )
    process = python(code, sigterm_timeout="0.2", sigkill_timeout="0.2")
    order = ShutdownProcess(process_matcher=matches_action(process))
    result = launch_these(
        RegisterEventHandler(OnProcessIO(target_action=process, on_stdout=lambda event: EmitEvent(event=order))),
        process,
    )
    ends = [line for line in without_numbers(result.lines) if "sending signal" in line or "escalating" in line]
    assert ends == [
        "[INFO] [p-N]: sending signal 'SIGINT' to process[p-N]",
        "[ERROR] [p-N]: process[p-N] failed to terminate '0.2' seconds after receiving 'SIGINT', escalating to 'SIGTERM'",
        "[INFO] [p-N]: sending signal 'SIGTERM' to process[p-N]",
        "[ERROR] [p-N]: process[p-N] failed to terminate '0.4' seconds after receiving 'SIGTERM', escalating to 'SIGKILL'",
        "[INFO] [p-N]: sending signal 'SIGKILL' to process[p-N]",
    ]
    assert process.return_code == -9


@pytest.mark.process
def test_a_process_is_started_again_as_often_as_wanted(launch_these: Callable[..., Any]) -> None:
    result = launch_these(python("print('again')", respawn=True, respawn_delay=0.01, respawn_max_retries=2))
    assert without_numbers(result.lines).count("[p-N] again") == 3


@pytest.mark.process
def test_a_shutdown_ends_the_waiting_for_a_respawn(launch_these: Callable[..., Any]) -> None:
    process = python("print('once')", respawn=True, respawn_delay=60.0)
    result = launch_these(process, RegisterEventHandler(OnProcessExit(on_exit=Shutdown())))
    assert without_numbers(result.lines).count("[p-N] once") == 1


def test_included_arguments_become_configurations(launch_these: Callable[..., Any]) -> None:
    inner = LaunchDescription([DeclareLaunchArgument("who"), LogInfo(msg=["hello ", LaunchConfiguration("who")])])
    include = IncludeLaunchDescription(LaunchDescriptionSource(inner), launch_arguments={"who": "you"}.items())
    assert said(launch_these(include).lines) == ["hello you"]


def test_a_choice_that_is_none_is_refused(launch_these: Callable[..., Any]) -> None:
    result = launch_these(
        SetLaunchConfiguration("mode", "C"), DeclareLaunchArgument("mode", default_value="A", choices=["A", "B"])
    )
    text = "Argument \"mode\" provided value \"C\" is not valid. Valid options are: ['A', 'B']"
    assert (result.status, result.lines[-1].endswith(text)) == (1, True)
    with pytest.raises(RuntimeError, match="is not in provided choices"):
        DeclareLaunchArgument("mode", default_value="C", choices=["A", "B"])
    assert DeclareLaunchArgument("m", choices=["A"], description="d").description == "d. Valid choices are: ['A']"


def test_an_exception_ends_the_launch_with_status_1(launch_these: Callable[..., Any]) -> None:
    def fail(context: Any) -> None:
        raise ValueError("boom")

    sleeper = python("import time; time.sleep(60)")
    result = launch_these(sleeper, OpaqueFunction(function=fail))
    assert result.status == 1
    assert "[ERROR] [launch]: Caught exception in launch (see debug for traceback): boom" in result.lines


def test_a_coroutine_keeps_the_launch_running_until_it_is_done(launch_these: Callable[..., Any]) -> None:
    import asyncio

    done = []

    async def work(context: Any, value: int) -> None:
        await asyncio.sleep(0.01)
        done.append(value)

    assert launch_these(OpaqueCoroutine(coroutine=work, args=[5])).status == 0
    assert done == [5]


def test_a_launch_file_sees_its_own_place(launch_these: Callable[..., Any], tmp_path: Any) -> None:
    (tmp_path / "a.launch.py").write_text(
        "from launch import LaunchDescription\n"
        "from launch.actions import LogInfo\n"
        "from launch.substitutions import ThisLaunchFile, ThisLaunchFileDir\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([LogInfo(msg=ThisLaunchFileDir()), LogInfo(msg=ThisLaunchFile())])\n"
    )
    include = IncludeLaunchDescription(PythonLaunchDescriptionSource(str(tmp_path / "a.launch.py")))
    assert said(launch_these(include).lines) == [str(tmp_path), str(tmp_path / "a.launch.py")]


def test_a_shutdown_may_be_awaited_while_the_launch_runs() -> None:
    async def play() -> tuple[int, list[Any]]:
        service = LaunchService()
        task = asyncio.ensure_future(service.run_async(shutdown_when_idle=False))
        while service.context.asyncio_loop is None:
            await asyncio.sleep(0.01)
        found = [service.task is task, service.event_loop is asyncio.get_running_loop()]
        found.append(await asyncio.ensure_future(service.shutdown()))
        status = await task
        return status, [*found, service.task, service.event_loop, service.shutdown()]

    assert asyncio.run(play()) == (0, [True, True, None, None, None, None])


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("a: 1\nb: {c: x}", {"a": 1, "b.c": "x"}),
        ("/**: {ros__parameters: {a: 1}}\n/ns/n: {ros__parameters: {b: 2}}", {"a": 1, "b": 2}),
        ("ns: {n: {ros__parameters: {b: 2}}, other: {ros__parameters: {b: 3}}}", {"b": 2}),
        ("other: {ros__parameters: {b: 3}}", {}),
        ("", {}),
    ],
)
def test_a_component_is_given_what_a_file_has_for_it(tmp_path: Any, text: str, values: dict[str, Any]) -> None:
    file = tmp_path / "p.yaml"
    file.write_text(text, encoding="utf-8")
    node = ComposableNode(package="p", plugin="q", name="n", namespace="ns", parameters=[str(file)])
    request = get_composable_node_load_request(node, LaunchContext())
    assert {each.name: Parameter.from_parameter_msg(each).value for each in request.parameters} == values
