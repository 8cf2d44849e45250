"""Command line arguments for ROS: those between `--ros-args` and `--` (rcl/arguments.c)."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any

from rclpy._rclpy_pybind11 import RCLError, RCLInvalidROSArgsError, UnknownROSArgsError

if TYPE_CHECKING:
    from day6_core.graph.names import RemapRule
    from rclpy._day6.logging_settings import LoggingSettings

START = "--ros-args"
END = "--"
_SWITCHES = frozenset(
    f"--{action}-{what}-logs" for action in ("enable", "disable") for what in ("stdout", "rosout", "external-lib")
)


class RosArguments:
    """The content of ROS arguments: remap rules, parameters by node pattern, log levels, switches."""

    def __init__(self, folder: str = "") -> None:
        self._folder = folder
        """Where relative names of parameter files begin; '' for the process's own folder."""
        self.rules: list[RemapRule] = []
        self.parameters: dict[str, dict[str, Any]] = {}
        """node pattern -> parameter name -> value; a later pattern wins over an earlier one"""
        self.levels: list[tuple[str, int]] = []
        """logger name ('' for all) and level"""
        self.log_config_file = ""
        self.log_file_name = ""
        """prefix of the log file's name; '' for the name of the program"""
        self.enclave = "/"
        self.switches: dict[str, bool] = {}
        self.unknown: list[str] = []

    def parameters_of(self, full_name: str) -> dict[str, Any]:
        """Return the parameters for the node with that full name."""
        if not self.parameters:
            return {}
        from rclpy._day6.parameter_files import matches

        found: dict[str, Any] = {}
        for pattern, parameters in self.parameters.items():
            if matches(pattern, full_name):
                found.update(parameters)
        return found

    def apply_levels(self, settings: LoggingSettings) -> None:
        """Set the log levels and outputs that the arguments name."""
        for name, level in self.levels:
            settings.set_level(name, level)
        settings.to_console = self.switches.get("stdout", True)
        settings.to_rosout = self.switches.get("rosout", True)
        if settings.file is not None:
            settings.file.enabled = settings.file.enabled and self.switches.get("external-lib", True)
            settings.file.program = self.log_file_name or settings.file.program

    def _add_rule(self, flag: str, text: str) -> None:
        from rclpy._day6.rule_lexer import RuleError, read_remap_rule

        try:
            self.rules.append(read_remap_rule(text))
        except RuleError as error:
            if error.warning:
                _log(30, error.warning)
            raise _refused("remap rule", flag, text, error, 380) from None

    def _add_parameter(self, flag: str, text: str) -> None:
        from rclpy._day6.parameter_files import ParameterTextError, add_override, assigned_value
        from rclpy._day6.rule_lexer import RuleError, read_parameter_rule

        try:
            node, name, value = read_parameter_rule(text)
            add_override(self.parameters.setdefault(node, {}), name, assigned_value(value))
        except (RuleError, ParameterTextError) as error:
            raise _refused("parameter override rule", flag, text, error, 352) from None

    def _add_file(self, flag: str, path: str) -> None:
        from rclpy._day6.parameter_files import ParameterTextError, add_override, read_parameter_file

        try:
            found = read_parameter_file(os.path.join(self._folder, path))
        except ParameterTextError as error:
            raise _refused("params file", flag, path, error, 415) from None
        for pattern, parameters in found.items():
            known = self.parameters.setdefault(pattern, {})
            for name, value in parameters.items():
                add_override(known, name, value)

    def _add_level(self, flag: str, text: str) -> None:
        from rclpy._day6.rule_lexer import RuleError, read_level_rule
        from rclpy.impl.logging_severity import LoggingSeverity

        name, separator, word = text.partition(":=")
        if not separator:
            name, word = "", text
        elif not name:
            reason = "Argument has an invalid logger item that name is empty, at /project/src/rcl/arguments.c:1808"
            raise _refused("log level", flag, text, reason, 441)
        else:
            try:
                word = read_level_rule(text)
            except RuleError as error:
                raise _refused("log level", flag, text, error, 441) from None
        try:
            level = LoggingSeverity[word.upper()]
        except KeyError:
            reason = "Argument does not use a valid severity level, at /project/src/rcl/arguments.c:1860"
            raise _refused("log level", flag, text, reason, 441) from None
        self.levels.append((name, int(level)))

    def _set_enclave(self, flag: str, text: str) -> None:
        from day6_core.graph import names

        flaw = names.flaw_of_namespace(text)
        if flaw is not None:
            reason = flaw.message.replace("namespace", "context name", 1)
            raise RCLError(
                f"failed to initialize rcl: Enclave name is not valid: '{reason}'. "
                f"Invalid index: {flaw.position}, at /project/src/rcl/init.c:243"
            )
        self.enclave = text

    def _name_log_file(self, flag: str, text: str) -> None:
        self.log_file_name = text

    def _name_config_file(self, flag: str, text: str) -> None:
        self.log_config_file = text


_Setter = Callable[[RosArguments, str, str], None]
_FLAGS: dict[str, tuple[_Setter, str]] = {
    "-r": (RosArguments._add_rule, "flag. No remap rule found., at /project/src/rcl/arguments.c:384"),
    "-p": (RosArguments._add_parameter, "flag. No parameter override rule found., at /project/src/rcl/arguments.c:356"),
    "--params-file": (RosArguments._add_file, "flag. No file path provided., at /project/src/rcl/arguments.c:419"),
    "--log-level": (RosArguments._add_level, ""),
    "-e": (RosArguments._set_enclave, "flag. No enclave path provided., at /project/src/rcl/arguments.c:550"),
    "--log-config-file": (
        RosArguments._name_config_file,
        "flag. No file path provided., at /project/src/rcl/arguments.c:515",
    ),
    "--log-file-name": (
        RosArguments._name_log_file,
        "flag. No string prefix provided., at /project/src/rcl/arguments.c:480",
    ),
}
for _long, _short in (("--remap", "-r"), ("--param", "-p"), ("--enclave", "-e")):
    _FLAGS[_long] = _FLAGS[_short]


def _refused(what: str, flag: str, text: str, reason: object, line: int) -> RCLError:
    return RCLError(
        f"failed to initialize rcl: Couldn't parse {what}: '{flag} {text}'. Error: {reason}, "
        f"at /project/src/rcl/arguments.c:{line}"
    )


_log_target: ContextVar[LoggingSettings | None] = ContextVar("_log_target", default=None)


def _log(severity: int, message: str) -> None:
    from rclpy._day6.logging_settings import PROCESS

    (_log_target.get() or PROCESS).emit(severity, "rcl", message, "", "", 0)


def _check_texts(args: Sequence[str]) -> None:
    if not all(isinstance(arg, str) for arg in args):
        raise TypeError("bad argument type for built-in operation")
    for arg in args:
        # Raises UnicodeEncodeError for an argument decoded with the wrong locale (PEP 383), as real rclpy does.
        arg.encode()


def parse_arguments(args: Sequence[str], folder: str = "") -> RosArguments:
    """Read arguments. Raises RCLError for bad ones, UnknownROSArgsError for unknown ones."""
    _check_texts(args)
    found = RosArguments(folder)
    inside = False
    words = iter(args)
    for word in words:
        if not inside:
            inside = word == START
            if not inside and ":=" in word:
                _take_old_rule(found, word)
        elif word == END:
            inside = False
        elif word in _SWITCHES:
            action, what = word[2:].removesuffix("-logs").split("-", 1)
            found.switches[what] = action == "enable"
        elif word in _FLAGS:
            setter, complaint = _FLAGS[word]
            value = next(words, None)
            if value is None:
                _complain(word, complaint)
            else:
                setter(found, word, value)
        elif word != START:
            found.unknown.append(word)
    if found.unknown:
        raise UnknownROSArgsError(found.unknown)
    return found


def _complain(flag: str, complaint: str) -> None:
    if flag == "--log-level":
        text = f"log level flag: '{flag}'. No log level provided., at /project/src/rcl/arguments.c:445"
    else:
        text = f"{flag} {complaint}"
    raise RCLError(f"failed to initialize rcl: Couldn't parse trailing {text}")


def _take_old_rule(found: RosArguments, word: str) -> None:
    """Read `from:=to` outside `--ros-args`, the syntax before ROS 2 Eloquent, which still works."""
    from rclpy._day6.rule_lexer import RuleError, read_remap_rule

    try:
        found.rules.append(read_remap_rule(word))
    except RuleError:
        # Then it is one of the program's own arguments.
        return
    hint = f"This syntax is deprecated. Use '--ros-args --remap {word}' instead."
    _log(30, f"Found remap rule '{word}'. {hint}")


def parse_node_arguments(args: Sequence[str]) -> RosArguments:
    """Read the arguments of one node: RCLInvalidROSArgsError for bad ones."""
    try:
        return parse_arguments(args)
    except RCLError as error:
        reason = str(error).replace("failed to initialize rcl: ", "Failed to parse ROS arguments: ", 1)
        raise RCLInvalidROSArgsError(reason) from None


def parse_global_arguments(
    args: Sequence[str], logging: LoggingSettings | None = None, folder: str = ""
) -> RosArguments:
    """Read a process's arguments for init(); a failure is also logged (to `logging`), as in rcl.

    Relative names of parameter files begin in `folder` ('': the process's own).
    """
    token = _log_target.set(logging)
    try:
        return parse_arguments(args, folder)
    except RCLError as error:
        if "Couldn't parse" in str(error):
            _log(40, "Failed to parse global arguments")
        raise
    finally:
        _log_target.reset(token)


def remove_ros_arguments(args: Sequence[str]) -> list[str]:
    """Return the arguments without those for ROS. Raises as `parse_arguments`."""
    _check_texts(args)
    kept: list[str] = []
    inside = False
    for word in args:
        if not inside:
            inside = word == START
            if not inside:
                kept.append(word)
        elif word == END:
            inside = False
    return kept
