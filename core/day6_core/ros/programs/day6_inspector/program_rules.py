"""Rules about what goes on inside programs: nobody spins, a callback does not come back, time stands still, a lost exception.

Also what the terminals say without words: a program that ended before its callbacks could run, domains that differ.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from day6_core.facts.names import are_alike
from day6_core.graph.domain import VARIABLE, DomainError, domain_from_text
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.files import Typed, in_home
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.process_reports import Busy, ReportedProcess, Standing
from day6_core.ros.programs.day6_inspector.sight import looks_at
from day6_core.ros.programs.day6_inspector.sign_rules import of_signs, opened
from day6_core.session.overview import TerminalView

LONG = 0.7
"""Seconds after which a callback counts as one that does not come back."""

LONG_FOR_NOBODY = 10.0
"""Seconds where nothing else waits to be run: then a callback may take its time."""

LATE = 0.7
"""Seconds by which a timer has to be overdue."""

LONG_BEGINNING = 2.5
"""Seconds that a node's __init__ may take."""

WRONG_KIND = 1.5
"""Seconds after which a service that is there, and for which somebody waits, is of another type."""

_WAITS = {
    "future": "future_in_callback",
    "spin": "spins_in_callback",
    "rate": "rate_in_callback",
    "service": "waits_in_callback",
    "event": "event_in_callback",
}
_ANSWERS = {
    ("thread", False): "calls_in_callback",
    ("group", False): "calls_in_group",
    ("thread", True): "calls_own_service",
    ("group", True): "calls_own_in_group",
}
"""Why an answer cannot come, and whether a callback of the same program would give it -> the finding."""

_READS = (
    (re.compile(r"\bsleep\s*\("), "sleeps_in_callback"),
    (re.compile(r"\binput\s*\("), "input_in_callback"),
)
"""What the line says at which a callback stays."""

_EARLY = re.compile(r"<launch(?:_ros)?\.substitutions\.")
"""How a substitution looks that was made a text before its time."""


@looks_at("programs")
def of_programs(facts: Facts) -> Iterator[Finding]:
    """Yield what is wrong inside the programs."""
    for process in facts.processes:
        yield from _of_process(facts, process)
    yield from of_signs(facts)
    for node in facts.silent_processes:
        yield finding("info", "tells_nothing", node=node)


def _of_process(facts: Facts, process: ReportedProcess) -> Iterator[Finding]:
    held_up = any(inside.late >= LATE or inside.waiting for inside in process.nodes)
    for busy in process.busy:
        certain = busy.blocked or busy.waits_for in ("spin", "service")
        if busy.seconds >= (LONG if held_up or certain else LONG_FOR_NOBODY):
            yield _busy(busy)
    for standing in process.standing:
        if standing.seconds >= LONG:
            found = _standing(facts, process, standing)
            if found is not None:
                yield found
    for argument in process.arguments:
        if _EARLY.search(argument):
            node = process.nodes[0].node if process.nodes else process.program
            yield finding("error", "launch_argument", node=node, value=argument)
    for hidden in process.hidden:
        if hidden.thread:
            yield thread_died(process.program, hidden.thread, hidden.error, hidden.place.short, opened(hidden.place))
            continue
        node = hidden.node or (process.nodes[0].node if process.nodes else process.program)
        said = {"node": node, "error": hidden.error, "where": hidden.place.short}
        yield finding("error", "hidden_error", **said, then=opened(hidden.place))
    blocked = {busy.node for busy in process.busy}
    script = Path(process.arguments[0]) if process.arguments else Path()
    edit = f"nano {shlex.quote(str(script))}" if script.suffix == ".py" else ""
    for inside in process.nodes:
        if inside.stands:
            then = f"ros2 param set {shlex.quote(inside.node)} use_sim_time false"
            yield finding("error", "no_clock", node=inside.node, then=then)
        elif inside.node in blocked or any(each.kind in ("rate", "call", "init") for each in process.standing):
            continue
        elif not inside.spins and (inside.late >= LATE or inside.waiting):
            key = "spin_ended" if inside.spun else "never_spun"
            yield finding("error", key, node=inside.node, program=process.program, then=edit)


def thread_died(program: str, thread: str, error: str, where: str, then: str) -> Finding:
    """Return the finding about a thread that an exception has ended."""
    return finding("error", "thread_died", program=program, thread=thread, error=error, where=where, then=then)


def _busy(busy: Busy) -> Finding:
    said = {"node": busy.node, "what": busy.what, "where": busy.place.short, "text": busy.place.text}
    key = _WAITS.get(busy.waits_for, "")
    if busy.waits_for in ("call", "future") and busy.waits_on and busy.blocked:
        key = _ANSWERS.get((busy.blocked, bool(busy.other)), "stays_in_callback")
        said |= {"name": busy.waits_on, "other": busy.other}
    key = key or next((key for reads, key in _READS if reads.search(busy.place.text)), "stays_in_callback")
    return finding("error", key, **said, then=opened(busy.place))


def _standing(facts: Facts, process: ReportedProcess, standing: Standing) -> Finding | None:
    node = process.nodes[0].node if process.nodes else process.program
    said = {"node": node, "where": standing.place.short}
    if standing.kind == "rate":
        return finding("error", "rate_alone", **said, then=opened(standing.place))
    if standing.kind == "call":
        return finding("error", "call_alone", **said, then=opened(standing.place))
    if standing.kind == "init":
        late = standing.seconds >= LONG_BEGINNING and any(each.late >= LATE or each.waiting for each in process.nodes)
        text = {"text": standing.place.text}
        return finding("error", "stays_in_init", **said, **text, then=opened(standing.place)) if late else None
    there = facts.actions if standing.kind == "action" else facts.services
    said |= {"name": standing.name}
    if standing.name in facts.servers:
        if standing.seconds < WRONG_KIND or standing.name not in there:
            return None
        then = f"ros2 {standing.kind} type {shlex.quote(standing.name)}"
        return finding("error", "program_waits_type", **said, type=", ".join(there[standing.name]), then=then)
    then = f"ros2 {standing.kind} list"
    near = [each for each in there if are_alike(standing.name, each)]
    if near:
        return finding("error", "program_waits_near", **said, near=near[0], then=then)
    return finding("error", f"program_waits_{standing.kind}", **said, then=then)


# -- what terminals say without words --------------------------------------------------------------------------------------


SOON_NS = 3_000_000_000
"""A program that ends so soon did not wait for anything."""

_MAKES_NODE = re.compile(r"\b(?:Node\s*\(|create_node\s*\()")
_HAS_CALLBACKS = re.compile(r"\bcreate_(?:timer|subscription|service)\s*\(")
_SPINS = re.compile(r"\bspin\w*\s*\(|\bExecutor\b|wait_for_message|\bWaitSet\b")


@looks_at("terminals")
def of_ended(facts: Facts) -> Iterator[Finding]:
    """Yield programs that ended at once because nothing in them spins."""
    for terminal in facts.terminals or ():
        line = terminal.lines[-1] if terminal.lines else None
        if line is None or line.status != 0 or line.ended_ns is None or line.ended_ns - line.began_ns > SOON_NS:
            continue
        path = script_of(line.source, line.cwd, home_of(terminal))
        text = facts.files.scripts.get(path, "") if path is not None and facts.files is not None else ""
        if path is None or not _MAKES_NODE.search(text) or not _HAS_CALLBACKS.search(text) or _SPINS.search(text):
            continue
        yield finding("error", "ended_unspun", program=path.name, then=f"nano {shlex.quote(str(path))}")


def home_of(terminal: TerminalView) -> Path:
    """Return what `~` means in a terminal: a drill has a home of its own."""
    return Path(terminal.variables.get("HOME", "/"))


def typed_as(terminal: TerminalView, source: str) -> Typed:
    """Return a running command of a terminal with the line to which it belongs, and where that was typed."""
    line = next((each for each in reversed(terminal.lines) if source.strip(" &") in each.source), None)
    if line is None:
        return Typed(source, (terminal.cwd,), home_of(terminal))
    return Typed(line.source, (line.cwd, terminal.cwd), home_of(terminal))


def script_of(source: str, cwd: Path, home: Path) -> Path | None:
    """Return the Python file that a command line runs, None if there is none."""
    with suppress(ValueError):
        words = shlex.split(source)
        if len(words) >= 2 and re.fullmatch(r"python3?(\.\d+)?", words[0]) and words[1].endswith(".py"):
            return cwd / in_home(words[1], home)
        if words and words[0].endswith(".py"):
            return cwd / in_home(words[0], home)
    return None


@looks_at("terminals", "nodes")
def of_domains(facts: Facts) -> Iterator[Finding]:
    """Yield domains in which nodes run that a terminal of another domain does not see."""
    terminals = {}
    for terminal in facts.terminals or ():
        with suppress(DomainError):
            terminals[terminal.number] = domain_from_text(terminal.variables.get(VARIABLE, ""))
    for number, domain in terminals.items():
        if domain != _common(list(terminals.values()), facts):
            for other, nodes in list(facts.domains_besides(domain).items())[:1]:
                said = {"number": number, "domain": domain, "other": other, "nodes": ", ".join(nodes)}
                yield finding("warning", "domains", **said, then=f"export ROS_DOMAIN_ID={other}")


def _common(domains: list[int], facts: Facts) -> int:
    """The domain that most terminals have; among equals that of the desktop."""
    return max(domains, key=lambda domain: (domains.count(domain), domain == facts.domain))
