"""Logging: levels and parents, lines on the console, filters, /rosout, level services."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from rcl_interfaces.msg import Log, LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

from rclpy import logging
from rclpy._day6.logging_settings import LoggingSettings
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.context import Context
from rclpy.impl import rcutils_logger
from rclpy.logging import LoggingSeverity
from rclpy.node import Node

METHODS = {"debug": 10, "info": 20, "warning": 30, "error": 40, "fatal": 50}


def say_all(logger: Any) -> list[bool]:
    """Log with every level; one line each, for a line logs with one level only."""
    return [
        logger.debug("say debug"),
        logger.info("say info"),
        logger.warning("say warning"),
        logger.error("say error"),
        logger.fatal("say fatal"),
    ]


@pytest.fixture(autouse=True)
def levels_as_at_the_start() -> Iterator[None]:
    yield
    for name in ("", "a", "a.b", "a.b.c", "ab", "l"):
        logging.set_logger_level(name, LoggingSeverity.UNSET if name else LoggingSeverity.INFO)


@pytest.mark.parametrize(
    ("text", "level"), [("debug", 10), ("Info", 20), ("WARN", 30), ("error", 40), ("fatal", 50), ("unset", 0)]
)
def test_a_level_is_named_in_any_case(text: str, level: int) -> None:
    assert logging.get_logging_severity_from_string(text) == level
    assert LoggingSeverity(level).name == text.upper()


def test_a_level_that_there_is_not_is_refused() -> None:
    with pytest.raises(RuntimeError):
        logging.get_logging_severity_from_string("loud")
    with pytest.raises(TypeError):
        logging.get_logging_severity_from_string(5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="15 is not a valid LoggingSeverity"):
        logging.set_logger_level("l", 15)
    with pytest.raises(ValueError, match="15 is not a valid LoggingSeverity"):
        logging.get_logger("l").set_level(15)
    for make in (lambda: logging.get_logger(""), lambda: logging.get_logger("a").get_child("")):
        with pytest.raises(ValueError, match=r"ogger name must not be empty."):
            make()


def test_the_level_of_the_nearest_parent_counts() -> None:
    logging.set_logger_level("", LoggingSeverity.WARN)
    logging.set_logger_level("a", LoggingSeverity.ERROR)
    logging.set_logger_level("a.b.c", LoggingSeverity.DEBUG)
    effective = {
        name: int(logging.get_logger_effective_level(name)) for name in ("a", "a.b", "a.b.c", "a.b.c.d", "ab", "x")
    }
    assert effective == {"a": 40, "a.b": 40, "a.b.c": 10, "a.b.c.d": 10, "ab": 30, "x": 30}
    assert [int(logging.get_logger_level(name)) for name in ("a", "a.b", "")] == [40, 0, 30]
    logging.set_logger_level("a", LoggingSeverity.UNSET)
    assert logging.get_logger_effective_level("a.b") == 30
    assert logging.get_logger("a.b").get_effective_level() == LoggingSeverity.WARN


@pytest.mark.parametrize("level", [0, 10, 20, 30, 40, 50])
def test_messages_below_the_level_are_not_logged(level: int, capfd: Any) -> None:
    logger = logging.get_logger("l")
    logger.set_level(level)
    effective = level or 20
    logged = say_all(logger)
    assert logged == [number >= effective for number in METHODS.values()]
    assert [logger.is_enabled_for(number) for number in METHODS.values()] == logged
    lines = capfd.readouterr().err.splitlines()
    assert [line.rpartition(" ")[2] for line in lines] == [name for name, each in METHODS.items() if each >= effective]


def test_loggers_of_other_packages_own_log_by_the_binding(capfd: Any) -> None:
    """As synchros2 has them."""
    from rclpy.impl.implementation_singleton import rclpy_implementation as binding

    for severity in METHODS.values():
        binding.rclpy_logging_rcutils_log(severity, "a.b", f"at {severity}", "turn", "wheels.py", 7)
    assert re.findall(r"at (\d+)", capfd.readouterr().err) == ["20", "30", "40", "50"]
    assert binding.rclpy_logging_logger_is_enabled_for("a.b", 20)
    binding.rclpy_logging_set_logger_level("a", 40)
    assert binding.rclpy_logging_get_logger_effective_level("a.b") == 40
    assert not binding.rclpy_logging_logger_is_enabled_for("a.b", 30)
    binding.rclpy_logging_rcutils_log(LoggingSeverity.WARN, "a.b", "below", "turn", "wheels.py", 8)
    assert capfd.readouterr().err == ""


def test_a_line_has_level_time_name_and_message(capfd: Any) -> None:
    logging.get_logger("a").get_child("b").warning("look")
    assert re.fullmatch(r"\[WARN\] \[\d{10}\.\d{9}\] \[a\.b\]: look\n", capfd.readouterr().err)


def test_the_old_name_of_warning_still_works(capfd: Any) -> None:
    with pytest.warns(DeprecationWarning, match="Deprecated in favor of"):
        assert logging.get_logger("l").warn("old")
    assert capfd.readouterr().err.startswith("[WARN]")


def test_a_message_is_a_text(capfd: Any) -> None:
    logger = logging.get_logger("l")
    with pytest.raises(TypeError, match=r"rclpy_logging_rcutils_log\(\): incompatible function arguments"):
        logger.info(5)  # type: ignore[arg-type]
    assert logger.log("plain", 30, name="other")
    assert capfd.readouterr().err.endswith("[other]: plain\n")


def test_once_lets_a_call_log_the_first_time_only() -> None:
    logger = logging.get_logger("l")
    assert [logger.info("x", once=True) for _ in range(3)] == [True, False, False]
    assert logger.info("x", once=True), "another line is another call"


def test_a_tool_that_wraps_the_loggers_is_not_who_logs(monkeypatch: pytest.MonkeyPatch) -> None:
    wrapper: dict[str, Any] = {}
    exec(compile("def say(logger): return logger.info('x', once=True)", "/opt/a_tool/wrapping.py", "exec"), wrapper)
    logger = logging.get_logger("l")
    assert [wrapper["say"](logger), wrapper["say"](logger)] == [True, False]
    monkeypatch.setattr(rcutils_logger, "_internal_callers", ["a_tool/wrapping.py"])
    assert wrapper["say"](logger), "who calls the tool is the caller"
    assert wrapper["say"](logger), "and this is another line"


def test_skip_first_lets_a_call_log_from_the_second_time_on() -> None:
    logger = logging.get_logger("l")
    assert [logger.info("x", skip_first=True) for _ in range(3)] == [False, True, True]


def test_skip_first_and_once_together_log_the_second_time() -> None:
    logger = logging.get_logger("l")
    assert [logger.info("x", skip_first=True, once=True) for _ in range(4)] == [False, True, False, False]


def test_throttle_lets_a_call_log_once_in_some_seconds() -> None:
    from rclpy.clock import ROSClock
    from rclpy.time import Time

    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    logger = logging.get_logger("l")
    logged = []
    for seconds in (10, 11.9, 12, 13.9, 14, 20):
        clock.set_ros_time_override(Time(seconds=seconds, clock_type=ClockType.ROS_TIME))
        logged.append(logger.info("x", throttle_duration_sec=2, throttle_time_source_type=clock))
    assert logged == [True, False, True, False, True, True]
    assert [logger.info("x", throttle_duration_sec=1000) for _ in range(2)] == [True, False]


def test_filters_are_asked_for_properly() -> None:
    logger = logging.get_logger("l")
    with pytest.raises(TypeError, match=r'parameter "loud" is not one of the recognized logging options'):
        logger.info("x", loud=True)
    with pytest.raises(TypeError, match=r'required parameter "throttle_duration_sec" not specified but is required'):
        logger.info("x", throttle_time_source_type=Clock())
    with pytest.raises(ValueError, match=r'Received throttle_time_source_type of "5" is not a clock instance'):
        logger.info("x", throttle_duration_sec=1, throttle_time_source_type=5)


@pytest.mark.parametrize(
    ("calls", "message"),
    [
        ([{"severity": 20}, {"severity": 30}], "Logger severity cannot be changed between calls."),
        (
            [{"severity": 20, "name": "a"}, {"severity": 20, "name": "b"}],
            "Logger name cannot be changed between calls.",
        ),
        (
            [{"severity": 20}, {"severity": 20, "once": True}],
            "Requested logging filters cannot be changed between calls.",
        ),
        (
            [{"severity": 20, "once": True}, {"severity": 20}],
            "Requested logging filters cannot be changed between calls.",
        ),
        (
            [{"severity": 20, "throttle_duration_sec": 1}, {"severity": 20, "throttle_duration_sec": 2}],
            "Logging filter parameters cannot be changed between calls.",
        ),
    ],
)
def test_one_call_always_asks_for_the_same(calls: list[dict[str, Any]], message: str) -> None:
    logger = logging.get_logger("l")

    def log(arguments: dict[str, Any]) -> None:
        logger.log("x", **arguments)

    log(calls[0])
    with pytest.raises(ValueError, match=message):
        log(calls[1])


# nodes


def test_what_a_node_logs_is_on_rosout(world: Any) -> None:
    node = world.node("n", namespace="lab")
    heard: list[Log] = []
    node.create_subscription(Log, "/rosout", heard.append, 10)
    say_all(node.get_logger())
    world.settle()
    assert [(log.level, log.name, log.msg) for log in heard] == [
        (20, "lab.n", "say info"),
        (30, "lab.n", "say warning"),
        (40, "lab.n", "say error"),
        (50, "lab.n", "say fatal"),
    ]
    log = heard[0]
    assert log.function == "say_all"
    assert log.file == __file__
    assert log.line == say_all.__code__.co_firstlineno + 4
    assert log.stamp.sec > 1_000_000_000


def test_a_child_of_a_nodes_logger_is_on_rosout_too(world: Any) -> None:
    node = world.node("n")
    heard: list[str] = []
    node.create_subscription(Log, "/rosout", lambda log: heard.append(log.name), 10)
    child = node.get_logger().get_child("part")
    child.info("x")
    world.settle()
    assert heard == ["n.part"]


def test_rosout_is_there_unless_it_is_not_wanted(world: Any) -> None:
    keeper = world.node("keeper", enable_rosout=False)
    assert keeper.count_publishers("/rosout") == 0
    node = world.node("n")
    assert keeper.count_publishers("/rosout") == 1
    node.destroy_node()
    world.settle()
    assert keeper.count_publishers("/rosout") == 0


def test_rosout_can_have_another_qos(world: Any) -> None:
    from rclpy.qos import DurabilityPolicy, ReliabilityPolicy

    node = world.node("default")
    (info,) = node.get_publishers_info_by_topic("/rosout")
    assert info.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
    assert info.qos_profile.reliability == ReliabilityPolicy.RELIABLE
    assert info.qos_profile.lifespan.nanoseconds == 10_000_000_000
    world.node("plain", rosout_qos_profile=5)
    infos = {each.node_name: each for each in node.get_publishers_info_by_topic("/rosout")}
    assert infos["plain"].qos_profile.durability == DurabilityPolicy.VOLATILE


def test_levels_are_asked_for_and_set_by_services(world: Any) -> None:
    node = world.node("n", enable_logger_service=True)
    getter = node.create_client(GetLoggerLevels, "n/get_logger_levels")
    setter = node.create_client(SetLoggerLevels, "n/set_logger_levels")
    levels = [LoggerLevel(name="l", level=40), LoggerLevel(name="ab", level=15)]
    results = world.until(setter.call_async(SetLoggerLevels.Request(levels=levels))).results
    assert [(each.successful, each.reason) for each in results] == [
        (True, ""),
        (False, "Failed reason: Invalid logger level."),
    ]
    found = world.until(getter.call_async(GetLoggerLevels.Request(names=["l", "ab", ""]))).levels
    assert [(each.name, each.level) for each in found] == [("l", 40), ("ab", 0), ("", 20)]
    world.until(setter.call_async(SetLoggerLevels.Request(levels=[LoggerLevel(name="l", level=0)])))


def test_a_node_has_no_level_services_unless_it_is_asked_to(world: Any) -> None:
    node = world.node("n")
    assert not any("logger_levels" in name for name, _ in node.get_service_names_and_types())


@pytest.mark.parametrize(
    ("arguments", "levels"),
    [
        (["--log-level", "warn"], {"": 30, "l": 30}),
        (["--log-level", "l:=error"], {"": 20, "l": 40}),
        (["--log-level", "DEBUG", "--log-level", "l:=FATAL"], {"": 10, "l": 50}),
    ],
)
def test_arguments_set_levels(arguments: list[str], levels: dict[str, int]) -> None:
    context = Context()
    context.init(["--ros-args", *arguments])
    assert {name: int(logging.get_logger_effective_level(name or "x")) for name in levels} == levels
    context.shutdown()


def test_arguments_switch_rosout_off() -> None:
    context = Context()
    context.init(["--ros-args", "--disable-rosout-logs", "--disable-stdout-logs"])
    node = Node("n", context=context)
    try:
        assert node.get_logger().info("nobody hears this")
    finally:
        context.shutdown()
        other = Context()
        other.init(["--ros-args", "--enable-rosout-logs", "--enable-stdout-logs"])
        other.shutdown()


def logged_by(script: str, **variables: str) -> tuple[str, str]:
    """Run a program that logs; returns what it wrote to its standard output and to standard error."""
    import subprocess
    import sys

    from day6_core.ros.environment import program_environment

    plain = {name: value for name, value in program_environment().items() if not name.startswith("RCUTILS_")}
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True, env={**plain, **variables})
    return done.stdout, done.stderr


@pytest.mark.process
def test_the_console_can_have_another_format() -> None:
    script = "import rclpy.logging\nrclpy.logging.get_logger('a.b').error('look')\n"
    form = (
        r"{severity}|{name}|{message}|{line_number}|{function_name}|{file_name}|{unknown}\t{time}|{time_as_nanoseconds}"
    )
    _, found = logged_by(script, RCUTILS_CONSOLE_OUTPUT_FORMAT=form + "|{date_time_with_ms}")
    pattern = (
        r"ERROR\|a\.b\|look\|2\|<module>\|(.*)\|\{unknown\}\t(\d{10}\.\d{9})\|(\d{19})"
        r"\|\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.(\d{3})\n"
    )
    match = re.fullmatch(pattern, found)
    assert match, found
    assert match[2].replace(".", "") == match[3]
    assert match[3][10:13] == match[4]
    assert match[1].endswith("<string>")


@pytest.mark.process
@pytest.mark.parametrize(
    ("variables", "to_stdout", "before", "after"),
    [
        ({}, False, "", ""),
        ({"RCUTILS_LOGGING_USE_STDOUT": "1"}, True, "", ""),
        ({"RCUTILS_COLORIZED_OUTPUT": "0"}, False, "", ""),
        ({"RCUTILS_COLORIZED_OUTPUT": "1"}, False, "\033[33m", "\033[0m"),
    ],
)
def test_variables_choose_stream_and_colours(
    variables: dict[str, str], to_stdout: bool, before: str, after: str
) -> None:
    out, err = logged_by("import rclpy.logging\nrclpy.logging.get_logger('l').warning('x')\n", **variables)
    used, unused = (out, err) if to_stdout else (err, out)
    assert re.fullmatch(re.escape(before) + r"\[WARN\] \[[\d.]+\] \[l\]: x" + re.escape(after) + "\n", used)
    assert unused == ""


@pytest.mark.parametrize(
    ("form", "line"),
    [
        ("{severity}-{name}-{message}", r"ERROR-a\.b-look"),
        ("{function_name}", "test_a_format_has_tokens"),
        ("{file_name}", re.escape(__file__)),
        ("{line_number}", r"\d+"),
        ("{time}", r"\d{10}\.\d{9}"),
        ("{time_as_nanoseconds}", r"\d{19}"),
        ("{date_time_with_ms}", r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3}"),
        ("{unknown} {message", r"\{unknown\} \{message"),
        (r"a\tb\nc", "a\tb\nc"),
        (r"\a\b\r|", "\a\b\r\\|"),
        ("", r"\[ERROR\] \[[\d.]+\] \[a\.b\]: look"),
    ],
)
def test_a_format_has_tokens(monkeypatch: pytest.MonkeyPatch, capfd: Any, form: str, line: str) -> None:
    monkeypatch.setenv("RCUTILS_CONSOLE_OUTPUT_FORMAT", form)
    logging.clear_config()
    logging.get_logger("a.b").error("look")
    monkeypatch.undo()
    logging.clear_config()
    assert re.fullmatch(line + "\n", capfd.readouterr().err)


def test_a_shutdown_of_logging_forgets_levels() -> None:
    logging.set_logger_level("l", 40)
    logging.set_logger_level("", 30)
    logging.shutdown()
    assert [int(logging.get_logger_effective_level(name)) for name in ("l", "x")] == [20, 20]
    logging.initialize()


def test_the_folder_of_log_files_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    from pathlib import Path

    monkeypatch.setenv("ROS_LOG_DIR", "/some/where")
    assert logging.get_logging_directory() == Path("/some/where")
    monkeypatch.delenv("ROS_LOG_DIR")
    monkeypatch.setenv("ROS_HOME", "/home/ros")
    assert logging.get_logging_directory() == Path("/home/ros/log")


@pytest.mark.parametrize(
    ("wish", "before", "after"),
    [("1", {10: "\033[32m", 20: "\033[0m", 30: "\033[33m", 40: "\033[31m", 50: "\033[31m"}, "\033[0m"), ("0", {}, "")],
)
def test_levels_have_colours(
    monkeypatch: pytest.MonkeyPatch, capfd: Any, wish: str, before: dict[int, str], after: str
) -> None:
    monkeypatch.setenv("RCUTILS_COLORIZED_OUTPUT", wish)
    logging.clear_config()
    logging.set_logger_level("l", 10)
    say_all(logging.get_logger("l"))
    monkeypatch.undo()
    logging.clear_config()
    for (name, level), line in zip(METHODS.items(), capfd.readouterr().err.splitlines(), strict=True):
        assert line.startswith(before.get(level, "") + "[")
        assert line.endswith(f"say {name}{after}")


class Stream:
    """A stream like sys.stderr that writes down what comes, or fails."""

    def __init__(self, tty: bool | None = None, error: Exception | None = None) -> None:
        self.text = ""
        self.error = error
        if tty is not None:
            self.isatty = lambda: tty

    def write(self, text: str) -> int:
        if self.error is not None:
            raise self.error
        self.text += text
        return len(text)


@pytest.mark.parametrize(
    ("wish", "tty", "coloured"),
    [
        (None, True, True),
        (None, False, False),
        (None, None, False),
        ("1", False, True),
        ("0", True, False),
        ("x", True, True),
    ],
)
def test_lines_are_coloured_on_a_terminal_or_where_that_is_wished(
    wish: str | None, tty: bool | None, coloured: bool
) -> None:
    settings = LoggingSettings(env={} if wish is None else {"RCUTILS_COLORIZED_OUTPUT": wish})
    stream = Stream(tty)
    settings.write = stream.write
    settings.emit(30, "a", "careful", "", "", 0)
    assert stream.text.endswith("[a]: careful\x1b[0m\n" if coloured else "[a]: careful\n")
    assert stream.text.startswith("\x1b[33m[WARN]" if coloured else "[WARN]")


@pytest.mark.parametrize("variable", ["0", "1", ""])
def test_lines_go_to_one_of_the_streams(monkeypatch: pytest.MonkeyPatch, variable: str) -> None:
    out, err = Stream(), Stream()
    monkeypatch.setattr("sys.stdout", out)
    monkeypatch.setattr("sys.stderr", err)
    LoggingSettings(env={"RCUTILS_LOGGING_USE_STDOUT": variable}).emit(20, "a", "x", "", "", 0)
    assert ("x" in out.text, "x" in err.text) == (variable == "1", variable != "1")


@pytest.mark.parametrize("stream", [None, Stream(error=OSError(28, "full")), Stream(error=ValueError("closed"))])
def test_a_console_that_takes_nothing_does_not_end_the_program(monkeypatch: pytest.MonkeyPatch, stream: Any) -> None:
    monkeypatch.setattr("sys.stderr", stream)
    LoggingSettings(env={}).emit(20, "a", "x", "", "", 0)


def test_what_cannot_go_to_rosout_is_told_on_the_console(world: Any) -> None:
    node = world.node("n")
    world.interrupt()
    node.get_logger().info("late")
    assert len(world.log) == 2
    assert "late" in world.log[0]
    assert world.log[1] == (
        "Failed to publish log message to rosout: publisher's context is invalid, at /project/src/rcl/publisher.c:427\n"
    )


def test_levels_of_a_name_are_forgotten_with_the_rest() -> None:
    settings = LoggingSettings(env={"RCUTILS_CONSOLE_OUTPUT_FORMAT": "{message}"})
    settings.set_level("a", 40)
    settings.set_level("", 10)
    assert [settings.effective_level(name) for name in ("a", "a.b", "b", "")] == [40, 40, 10, 10]
    assert [settings.level(name) for name in ("a", "a.b", "")] == [40, 0, 10]
    settings.reset()
    assert [settings.effective_level(name) for name in ("a", "a.b", "b", "")] == [20, 20, 20, 20]


def test_a_line_that_nobody_wants_is_written_nowhere() -> None:
    settings = LoggingSettings(env={})
    stream = Stream()
    settings.write = stream.write
    settings.to_console = False
    settings.emit(50, "a", "x", "", "", 0)
    assert stream.text == ""
    settings.to_console = True
    settings.emit(50, "a", "x", "", "", 0)
    assert stream.text.endswith("[a]: x\n")
