"""What the last lines in the terminals printed: the faults that a program, a command or colcon names itself.

The cards of `day6_core.advice` say in which lines a finding is seen; those with a judge here are looked into first. A line's
finding goes when the same line is run again, when others come after it, or with time.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path

from day6_core.advice.card_files import Card, all_cards, names_of
from day6_core.advice.fault import own_places
from day6_core.advice.matching import Sighting, sightings
from day6_core.advice.wording import command_of
from day6_core.facts.names import absolute
from day6_core.facts.workspaces import Workspace, is_sourced
from day6_core.ros.distribution import setup_script
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import ORDER, Finding, finding
from day6_core.ros.programs.day6_inspector.frame_rules import of_extrapolation, of_frame
from day6_core.ros.programs.day6_inspector.outputs import LineOutput, outputs, shortened
from day6_core.ros.programs.day6_inspector.program_rules import thread_died
from day6_core.ros.programs.day6_inspector.sight import looks_at

_ERROR = re.compile(
    r"^([A-Za-z_][\w.]*(?:Error|Exception|Interrupt|Exists|Exit|Warning)\w*)(?::[ ]?(.*))?$", re.MULTILINE
)

_THREAD = re.compile(r"^(?:\[[\w.-]+-\d+\] )?Exception in thread (.+?):(?: .*)?$", re.MULTILINE)
"""How Python begins to report a thread that an exception has ended."""

_CHAINED = re.compile(r"^(?:\[[\w.-]+-\d+\] )?(?:During handling of the above|The above exception was)", re.MULTILINE)
"""How an exception begins to name another one that led to it, whose report stands above."""


@looks_at("terminals")
def of_outputs(facts: Facts) -> Iterator[Finding]:
    """Yield what the terminals' last lines say about themselves: of each line the first fault."""
    for output in outputs(facts):
        found = _first(output, facts)
        if found is not None:
            yield found


def _first(output: LineOutput, facts: Facts) -> Finding | None:
    for card in _cards() if output.text else ():
        if seen := sightings(card, output.text):
            judge = _JUDGES.get(card.finding)
            found = judge(output, seen, facts) if judge is not None else _as_said(card, output, seen[0])
            if found is not None:
                return found
    return None


@lru_cache(maxsize=1)
def _cards() -> tuple[Card, ...]:
    """The cards that are findings, in the order in which they are looked for: the worst first, last what only echoes others."""
    cards = (card for card in all_cards() if card.finding)
    return tuple(sorted(cards, key=lambda card: (card.echo, ORDER[card.level])))


def _as_said(card: Card, output: LineOutput, seen: Sighting) -> Finding:
    """The finding as the card has it: about the student's own program, or about what was run."""
    names = names_of(card.words["en"].finding)
    values = {name: seen.values[name].strip() for name in names - {"where", "line"}}
    if "where" in names:
        return finding(card.level, card.finding, where=_where(output), **values, then=_open(output))
    then = command_of(card.finding_next or card.next, values)
    return finding(card.level, card.finding, line=output.source, **values, then=then)


Judge = Callable[[LineOutput, Sequence[Sighting], Facts], Finding | None]
"""Looks into what a card has seen; None where it is no fault, or none any more."""


# -- packages and files ---------------------------------------------------------------------------------------------------


def _no_package(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    return unknown_package(output, seen[0].values["name"], facts)


def _build(workspace: Workspace) -> str:
    return f"cd {shlex.quote(str(workspace.folder))} && colcon build && source install/setup.bash"


def unknown_package(output: LineOutput, name: str, facts: Facts) -> Finding | None:
    """Say why a package is not found: not sourced, not built, or no such package."""
    found = facts.package(name)
    if found is None:
        return finding("error", "no_package", line=output.source, package=name, then="ros2 pkg list")
    workspace, package = found
    setup = workspace.install / "setup.bash"
    if not package.built:
        said = {"line": output.source, "package": name, "folder": package.folder}
        return finding("error", "not_built", **said, then=_build(workspace))
    if not is_sourced(name, workspace.install, output.terminal.variables):
        said = {"line": output.source, "package": name, "number": output.terminal.number}
        return finding("error", "not_sourced", **said, then=f"source {shlex.quote(str(setup))}")
    return None


def _no_executable(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    words = output.line.source.split()
    plain_words = [word for word in words[2:] if not word.startswith("-")] if words[:2] == ["ros2", "run"] else []
    if len(plain_words) < 2:
        return None
    name, executable = plain_words[:2]
    found = facts.package(name)
    said = {"line": output.source, "package": name, "executable": executable}
    if found is None:
        return finding("error", "no_executable", **said, then=f"ros2 pkg executables {name}")
    workspace, package = found
    if package.in_bin:
        return finding(
            "error", "no_setup_cfg", package=name, then=f"nano {shlex.quote(str(package.folder / 'setup.cfg'))}"
        )
    if any(entry.name == executable for entry in package.entry_points):
        return finding("error", "entry_not_built", **said, then=_build(workspace))
    if entry_line := package.lacking_entry(executable):
        edit = f"nano {shlex.quote(str(package.install_script))}"
        return finding("error", "no_entry_point", **said, entry=entry_line, then=edit)
    return finding("error", "no_executable", **said, then=f"ros2 pkg executables {name}")


def _no_launch_file(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    name, package_name, share = (seen[0].values[each] for each in ("name", "package", "share"))
    found = facts.package(package_name)
    if found is not None:
        workspace, package = found
        there = package.file_called(name)
        if there is not None and not {there, "setup.py"}.isdisjoint(package.changed):
            said = {"line": output.source, "file": name, "package": package_name}
            return finding("error", "launch_not_built", **said, then=_build(workspace))
        if there is not None:
            where = package.install_script
            said = {"file": there, "package": package_name, "where": where.name}
            return finding("error", "launch_not_installed", **said, then=f"nano {shlex.quote(str(where))}")
    then = f"ls {shlex.quote(share)}/launch"
    return finding("error", "no_launch_file", file=name, package=package_name, then=then)


def _gone_folder(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    entry, variable = seen[0].values["path"], seen[0].values["variable"]
    then = f"unset {variable}; source {setup_script()}"
    return finding("warning", "gone", number=output.terminal.number, variable=variable, entry=entry, then=then)


def _duplicates(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    named = re.search(r"^- (\S+):\n((?:  - .*\n?)+)", seen[0].rest, re.MULTILINE)
    if named is None:
        return finding("error", "duplicates", package="?", folders="?")
    folders = [each.strip()[2:] for each in named[2].splitlines()]
    then = f"touch {shlex.quote(str(output.line.cwd / folders[0]))}/COLCON_IGNORE"
    return finding("error", "duplicates", package=named[1], folders=", ".join(folders), then=then)


def _no_type(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    type_name = seen[0].values["type"] or _type_in(output.line.source)
    package = type_name.partition("/")[0]
    if package:
        found = unknown_package(output, package, facts)
        if found is not None and found.id != "inspector.no_package":
            return found
    then = f"ros2 interface packages | grep {shlex.quote(package)}" if package else "ros2 interface list"
    return finding("error", "no_type", line=output.source, type=type_name or "?", then=then)


def _type_in(source: str) -> str:
    """The first type that a command line names, '' if it names none."""
    pattern = r"[A-Za-z]\w*/(?:(?:msg|srv|action)/)?[A-Za-z]\w*"
    return next((word for word in source.split() if re.fullmatch(pattern, word)), "")


# -- Python ---------------------------------------------------------------------------------------------------------------


def own_frame(output: LineOutput) -> tuple[str, int] | None:
    """Return file and line of the last frame of a traceback that is not in a library."""
    return next(iter(reversed([*own_places(output.text)])), None)


def _open(output: LineOutput) -> str:
    frame = own_frame(output)
    if frame is None:
        return ""
    path = output.line.cwd / frame[0]
    return f"nano +{frame[1]} {shlex.quote(str(path))}"


def _where(output: LineOutput) -> str:
    frame = own_frame(output)
    return f"{Path(frame[0]).name}:{frame[1]}" if frame is not None else output.source


def _parameter_type(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    words = output.line.source.split()
    if words[:3] != ["ros2", "param", "set"] or len(words) < 6 or "parameter" in seen[0].values:
        name = seen[0].values.get("parameter", "?")
        return finding("error", "parameter_type", where=_where(output), parameter=name, then=_open(output))
    node, name = words[3:5]
    then = f"ros2 param describe {node} {name}"
    return finding("error", "parameter_type", where=output.source, parameter=name, then=then)


def _missing_module(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    name = seen[0].values["module"]
    found = unknown_package(output, name.partition(".")[0], facts)
    if found is not None and found.id != "inspector.no_package":
        return found
    return finding("error", "no_module", where=_where(output), module=name, then=_open(output))


def _traceback(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    errors = _ERROR.findall(seen[0].rest)
    if not errors:
        return None
    kind, message = errors[-1]
    if kind == "KeyboardInterrupt":
        return finding("info", "ctrl_c", line=output.source)
    said = f"{kind}: {message}" if message else kind
    thread = _ended_thread(output.text)
    if thread:
        if any(hidden.thread == thread for process in facts.processes for hidden in process.hidden):
            return None  # the program itself has told it
        return thread_died(output.source, thread, shortened(said), _where(output), _open(output))
    if output.running and not output.line.source.startswith("ros2 launch"):
        return finding("warning", "exception_shown", where=_where(output), error=shortened(said), then=_open(output))
    return finding("error", "exception", where=_where(output), error=shortened(said), then=_open(output))


def _ended_thread(text: str) -> str:
    """Return the thread whose exception is the last one of an output, '' where it is the program's own."""
    report = next(reversed(list(_THREAD.finditer(text))), None)
    if report is None:
        return ""
    after = text[report.end() :]
    return report[1] if after.count("Traceback (most recent") - len(_CHAINED.findall(after)) == 1 else ""


# -- commands that wait -----------------------------------------------------------------------------------------------------


def _waits(key: str, kind: str, verb: str) -> Judge:
    """A command or program that has been waiting since it said so."""

    def judge(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
        if not output.running or seen[-1].rest.strip():
            return None
        words = [word for word in output.line.source.split() if not word.startswith("-")]
        name = words[3] if words[:3] == ["ros2", kind, verb] and len(words) > 3 else ""
        if absolute(name) in facts.servers:
            return None
        return finding("error", key, line=output.source, then=f"ros2 {kind} list")

    return judge


def _two_types(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    topic = seen[0].values["name"]
    if len({each.type for each in facts.ends(topic)}) < 2:
        return None  # it was so
    return finding("error", "two_types_said", line=output.source, topic=topic, then="ros2 topic list -t")


def _bad_yaml(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    type_name = _type_in(output.line.source)
    then = f"ros2 interface show {type_name}" if type_name else ""
    reason = seen[0].values.get("reason", seen[0].line).strip()
    return finding("error", "bad_yaml", line=output.source, reason=reason, then=then)


_JUDGES: dict[str, Judge] = {
    "no_executable": _no_executable,
    "no_package": _no_package,
    "no_launch_file": _no_launch_file,
    "duplicates": _duplicates,
    "gone": _gone_folder,
    "no_type": _no_type,
    "bad_yaml": _bad_yaml,
    "two_types_said": _two_types,
    "parameter_type": _parameter_type,
    "no_module": _missing_module,
    "no_frame": of_frame,
    "extrapolation": of_extrapolation,
    "waits_service": _waits("waits_service", "service", "call"),
    "waits_action": _waits("waits_action", "action", "send_goal"),
    "exception": _traceback,
}
"""Key of a finding -> what looks into it; the others are as their cards say."""
