"""What the last lines in the terminals printed: the faults that a program, a command or colcon names itself.

A table of patterns; a line's finding goes when the same line is run again, when others come after it, or with time.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path

from day6_core.facts.workspaces import is_sourced
from day6_core.ros.distribution import setup_script
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.frame_rules import NO_FRAME, of_extrapolation, of_frame
from day6_core.ros.programs.day6_inspector.outputs import Output, outputs, shortened

_OWN = Path(__file__).resolve().parents[3]
"""Where this program is: in a checkout, not among the libraries."""

_FRAME = re.compile(r'^\s*File "([^"]+)", line (\d+)', re.MULTILINE)
_ERROR = re.compile(
    r"^([A-Za-z_][\w.]*(?:Error|Exception|Interrupt|Exists|Exit|Warning)\w*)(?::[ ]?(.*))?$", re.MULTILINE
)


def of_outputs(facts: Facts) -> Iterator[Finding]:
    """Yield what the terminals' last lines say about themselves: of each line the first fault."""
    for output in outputs(facts):
        found = _first(output, facts)
        if found is not None:
            yield found


def _first(output: Output, facts: Facts) -> Finding | None:
    if not output.text:
        return None
    for needle, pattern, judge in _TABLE:
        if needle in output.text and (match := re.search(pattern, output.text, re.MULTILINE)) is not None:
            found = judge(output, match, facts)
            if found is not None:
                return found
    return None


Judge = Callable[[Output, "re.Match[str]", Facts], Finding | None]


# -- packages and files ---------------------------------------------------------------------------------------------------


def _no_package(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    return unknown_package(output, match[1], facts)


def unknown_package(output: Output, name: str, facts: Facts) -> Finding | None:
    """Say why a package is not found: not sourced, not built, or no such package."""
    found = facts.files.package(name) if facts.files is not None else None
    if found is None:
        return finding("error", "no_package", line=output.source, package=name, then="ros2 pkg list")
    workspace, package = found
    setup = workspace.install / "setup.bash"
    if not package.built:
        build = f"cd {shlex.quote(str(workspace.folder))} && colcon build && source install/setup.bash"
        return finding("error", "not_built", line=output.source, package=name, folder=package.folder, then=build)
    if not is_sourced(name, workspace.install, output.terminal.variables):
        then = f"source {shlex.quote(str(setup))}"
        return finding(
            "error", "not_sourced", line=output.source, package=name, number=output.terminal.number, then=then
        )
    return None


def _no_executable(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    words = output.line.source.split()
    plain_words = [word for word in words[2:] if not word.startswith("-")] if words[:2] == ["ros2", "run"] else []
    if len(plain_words) < 2:
        return None
    name, executable = plain_words[:2]
    found = facts.files.package(name) if facts.files is not None else None
    said = {"line": output.source, "package": name, "executable": executable}
    if found is None:
        return finding("error", "no_executable", **said, then=f"ros2 pkg executables {name}")
    workspace, package = found
    build = f"cd {shlex.quote(str(workspace.folder))} && colcon build && source install/setup.bash"
    if package.in_bin:
        return finding(
            "error", "no_setup_cfg", package=name, then=f"nano {shlex.quote(str(package.folder / 'setup.cfg'))}"
        )
    if any(entry.name == executable for entry in package.entry_points):
        return finding("error", "entry_not_built", **said, then=build)
    if entry_line := package.lacking_entry(executable):
        edit = f"nano {shlex.quote(str(package.install_script))}"
        return finding("error", "no_entry_point", **said, entry=entry_line, then=edit)
    return finding("error", "no_executable", **said, then=f"ros2 pkg executables {name}")


def _no_launch_file(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    name, package_name = match[1], match[2]
    found = facts.files.package(package_name) if facts.files is not None else None
    share = match[3] if match.lastindex and match.lastindex >= 3 else ""
    if found is not None:
        workspace, package = found
        there = package.file_called(name)
        if there is not None and "setup.py" in package.changed:
            build = f"cd {shlex.quote(str(workspace.folder))} && colcon build && source install/setup.bash"
            return finding("error", "launch_not_built", line=output.source, file=name, package=package_name, then=build)
        if there is not None:
            where = package.install_script
            said = {"file": there, "package": package_name, "where": where.name}
            return finding("error", "launch_not_installed", **said, then=f"nano {shlex.quote(str(where))}")
    then = f"ls {shlex.quote(share)}/launch" if share else ""
    return finding("error", "no_launch_file", file=name, package=package_name, then=then)


def _gone_folder(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    then = f"unset {match[2]}; source {setup_script()}"
    return finding("warning", "gone", number=output.terminal.number, variable=match[2], entry=match[1], then=then)


def _duplicates(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    block = output.text[match.end() :]
    named = re.search(r"^- (\S+):\n((?:  - .*\n?)+)", block, re.MULTILINE)
    if named is None:
        return finding("error", "duplicates", package="?", folders="?")
    folders = [each.strip()[2:] for each in named[2].splitlines()]
    then = f"touch {shlex.quote(str(output.line.cwd / folders[0]))}/COLCON_IGNORE"
    return finding("error", "duplicates", package=named[1], folders=", ".join(folders), then=then)


def _no_type(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    known = [
        word
        for word in output.line.source.split()
        if re.fullmatch(r"[A-Za-z]\w*(/(?:msg|srv|action))?/[A-Za-z]\w*", word)
    ]
    type_name = (match[1] if match.lastindex else "") or (known[0] if known else "")
    package = type_name.partition("/")[0]
    if package:
        found = unknown_package(output, package, facts)
        if found is not None and found.id != "inspector.no_package":
            return found
    then = f"ros2 interface packages | grep {shlex.quote(package)}" if package else "ros2 interface list"
    return finding("error", "no_type", line=output.source, type=type_name or "?", then=then)


# -- Python ---------------------------------------------------------------------------------------------------------------


def own_frame(output: Output) -> tuple[str, int] | None:
    """Return file and line of the last frame of a traceback that is not in a library."""
    last = None
    for file, line in _FRAME.findall(output.text):
        parts = Path(file).parts
        if "site-packages" in parts and "install" not in parts:
            continue
        if file.startswith("<") or (any(part.startswith("python3") for part in parts[:-1]) and "install" not in parts):
            continue
        if {"day6_core", "ros", "python"} <= set(parts) or "rclpy" in parts or _OWN in Path(file).parents:
            continue
        last = file, int(line)
    return last


def _open(output: Output) -> str:
    frame = own_frame(output)
    if frame is None:
        return ""
    path = output.line.cwd / frame[0]
    return f"nano +{frame[1]} {shlex.quote(str(path))}"


def _where(output: Output) -> str:
    frame = own_frame(output)
    return f"{Path(frame[0]).name}:{frame[1]}" if frame is not None else output.source


def _python(key: str, *names: str, level: str = "error") -> Judge:
    """A fault in the student's own program: the text gets the groups of the pattern by these names."""

    def judge(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
        values = {name: (match[number] or "").strip() for number, name in enumerate(names, 1)}
        return finding(level, key, where=_where(output), **values, then=_open(output))

    return judge


def _says(key: str, then: str = "", level: str = "error", *names: str) -> Judge:
    """A fault whose next command is always the same."""

    def judge(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
        values = {name: (match[number] or "").strip() for number, name in enumerate(names, 1)}
        return finding(level, key, line=output.source, **values, then=then)

    return judge


def _parameter_type(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    words = output.line.source.split()
    if words[:3] != ["ros2", "param", "set"] or len(words) < 6:
        return finding("error", "parameter_type", where=_where(output), parameter="?", then=_open(output))
    node, name = words[3:5]
    then = f"ros2 param describe {node} {name}"
    return finding("error", "parameter_type", where=output.source, parameter=name, then=then)


def _missing_module(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    name = match[1]
    package = name.partition(".")[0]
    if package == "rclpy":
        return finding("error", "no_rclpy", line=output.source, then=f"source {setup_script()}")
    found = unknown_package(output, package, facts)
    if found is not None and found.id != "inspector.no_package":
        return found
    return finding("error", "no_module", where=_where(output), module=name, then=_open(output))


def _traceback(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    errors = _ERROR.findall(output.text[match.start() :])
    if not errors:
        return None
    kind, message = errors[-1]
    if kind == "KeyboardInterrupt":
        return finding("info", "ctrl_c", line=output.source)
    said = f"{kind}: {message}" if message else kind
    return finding("error", "exception", where=_where(output), error=shortened(said), then=_open(output))


# -- commands that wait -----------------------------------------------------------------------------------------------------


def _waits(key: str, command: tuple[str, str], then: str) -> Judge:
    """A command or program that has been waiting since it said so."""

    def judge(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
        last = output.text.rstrip().rpartition("\n")[2]
        if not output.running or match[0] not in last:
            return None
        words = [word for word in output.line.source.split() if not word.startswith("-")]
        name = words[3] if tuple(words[:3]) == ("ros2", *command) and len(words) > 3 else ""
        if _absolute(name) in facts.servers:
            return None
        return finding("error", key, line=output.source, then=then)

    return judge


def _absolute(name: str) -> str:
    return name if name.startswith("/") else f"/{name}"


def _two_types(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    topic = match[1]
    if len({each.type for ends in (facts.publishers, facts.subscriptions) for each in ends.get(topic, ())}) < 2:
        return None  # it was so
    return finding("error", "two_types_said", line=output.source, topic=topic, then="ros2 topic list -t")


def _bad_yaml(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    words = [
        word
        for word in output.line.source.split()
        if re.fullmatch(r"[A-Za-z]\w*/(?:(?:msg|srv|action)/)?[A-Za-z]\w*", word)
    ]
    then = f"ros2 interface show {words[0]}" if words else ""
    reason = match[1].strip() if match.lastindex else match[0].strip()
    return finding("error", "bad_yaml", line=output.source, reason=reason, then=then)


_OPT = f"source {setup_script()}"

_TABLE: tuple[tuple[str, str, Judge], ...] = (
    # a word that must be there (quick to look for), the pattern, what it means
    ("_rclpy_pybind11", r"No module named 'rclpy\._rclpy_pybind11'", _says("other_python", "which python3")),
    ("isn't present on the system", r"The C extension '([^']*)' isn't present", _says("other_python", "which python3")),
    ("No executable found", r"^No executable found", _no_executable),
    ("not found", r"^(?:\[ERROR\].*)?Package '([^']+)' not found", _no_package),
    ("not found, searching", r"package '([^']+)' not found, searching", _no_package),
    (
        "was not found in the share directory",
        r"file '([^']+)' was not found in the share directory of package '([^']+)' which is at '([^']+)'",
        _no_launch_file,
    ),
    (
        "command not found",
        r"\b(ros2|colcon|rviz2|rqt_graph): command not found",
        _says("no_ros", _OPT, "error", "command"),
    ),
    ("Duplicate package names", r"Duplicate package names not supported:\n", _duplicates),
    (
        "in the environment variable",
        r"[Tt]he path '([^']+)' in the environment variable (\w+_PREFIX_PATH) doesn't exist",
        _gone_folder,
    ),
    ("message type is invalid", r"The passed message type is invalid", _no_type),
    (
        "is invalid",
        r"The (?:message|service|action|passed service|passed action) type(?: '([^']+)')? is invalid",
        _no_type,
    ),
    ("Unknown package", r"Unknown package '([^']+)'", _no_type),
    ("Failed to populate field", r"Failed to populate field: (.*)", _bad_yaml),
    ("dictionary in YAML", r"The passed value needs to be a dictionary in YAML format", _bad_yaml),
    (
        "more than one type",
        r"topic '([^']+)', as it contains more than one type",
        _two_types,
    ),
    ("Zenoh router", r"Unable to connect to a Zenoh router", _says("no_router", "ros2 run rmw_zenoh_cpp rmw_zenohd")),
    # Python, the student's own program
    (
        "object has no attribute '_",
        r"AttributeError: '(\w+)' object has no attribute '_\w+'",
        _python("no_super", "kind"),
    ),
    ("NotInitializedException", r"NotInitializedException", _python("no_init")),
    (
        "module 'rclpy' has no attribute",
        r"AttributeError: module 'rclpy' has no attribute '(\w+)'",
        _python("submodule", "name"),
    ),
    (
        "'qos_profile'",
        r"TypeError: .*create_(publisher|subscription)\(\) missing .*'qos_profile'",
        _python("no_depth", "kind"),
    ),
    (
        "Expected <class",
        r"TypeError: Expected <class '(?:\w+\.)*(\w+)'>, got <class '(\w+)'>",
        _python("not_a_message", "type", "got"),
    ),
    (
        "field must be of type",
        r"AssertionError: The '(\w+)' field must be of type '(\w+)'",
        _python("field_type", "field", "type"),
    ),
    ("callback should be", r"callback should be either be callable", _python("called_callback")),
    ("undeclared parameter", r"undeclared parameter\(s\): (\S+)", _python("undeclared", "parameter")),
    ("Wrong parameter type", r"Wrong parameter type", _parameter_type),
    (
        "expecting type",
        r"Trying to set parameter '([^']+)' to '.*' of type",
        _python("parameter_type", "parameter"),
    ),
    (
        "object has no attribute",
        r"AttributeError: '(\w+)' object has no attribute '(\w+)'",
        _python("attribute", "type", "name"),
    ),
    ("No module named", r"ModuleNotFoundError: No module named '([\w.]+)'", _missing_module),
    (
        "shutdown",
        r"rcl_shutdown already called|Context (?:already shutdown|must be initialized before it can be shutdown)",
        _says("shut_twice", "", "info"),
    ),
    # TF
    (NO_FRAME, r'"(\w[^"]*)" passed to \w+ argument \w+ does not exist', of_frame),
    ("frame does not exist", r'Invalid frame ID "([^"]+)" passed to canTransform', of_frame),
    (
        "extrapolation into the",
        r"Lookup would require extrapolation into the (future|past)",
        of_extrapolation,
    ),
    # waiting
    (
        "waiting for service",
        r"waiting for service to become available",
        _waits("waits_service", ("service", "call"), "ros2 service list"),
    ),
    (
        "service not available",
        r"service not available, waiting",
        _waits("waits_service", ("service", "call"), "ros2 service list"),
    ),
    (
        "Waiting for an action server",
        r"Waiting for an action server to become available",
        _waits("waits_action", ("action", "send_goal"), "ros2 action list"),
    ),
    ("Goal was rejected", r"Goal was rejected", _says("goal_rejected", "ros2 action list -t", "warning")),
    # names
    (
        "Publisher already registered",
        r"Publisher already registered for (?:provided )?node name: '([^']+)'",
        _says("twin_said", "ros2 node list", "warning", "name"),
    ),
    # harmless
    ("SetuptoolsDeprecationWarning", r"SetuptoolsDeprecationWarning", _says("setuptools", "", "info")),
    ("Traceback (most recent", r"Traceback \(most recent call last\):", _traceback),
)
