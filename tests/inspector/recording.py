"""The facts of real machines as text: what `record_facts.py` writes down once, and rules judge again without any process.

Only fields that are not as they are by default are written. Paths, times, numbers of processes and the like, which are others on
every machine, are replaced by the same ones everywhere.
"""

from __future__ import annotations

import dataclasses
import json
import re
import sys
import tempfile
import types
from collections.abc import Mapping, Sequence
from enum import Enum
from pathlib import Path
from typing import Any, NamedTuple, Union, get_args, get_origin, get_type_hints

from day6_core.graph.domain import VARIABLE
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.outputs import LAST_LINES, LONGEST, plain
from day6_core.ros.programs.day6_inspector.rules import findings
from day6_core.session.overview import RunLine

RECORDED = Path(__file__).with_name("recorded.jsonl")
"""One case a line."""

ROOT = Path(__file__).resolve().parents[2]
HOME = "/home/student"
INSTALLED = "/usr/lib/python3/site-packages/day6_tui"
NOW_NS = 1_700_000_000 * 10**9
VARIABLES = ("AMENT_PREFIX_PATH", "HOME", VARIABLE)
"""Those that rules ask for."""

NUMBERS = (
    (r"\bpid( \[?)\d+", r"pid\g<1>1"),
    (rf"{re.escape(tempfile.gettempdir())}/[\w.-]+", "/scratch"),
    (r"/log/[\d-]+-[\w.-]+-\d+", "/log/1"),
)
"""Numbers and names that are others each time, and what stands for them."""

Json = Any


class Ran(NamedTuple):
    """A line of a terminal, as it was."""

    number: int
    source: str
    cwd: Path
    began_ns: int
    ended_ns: int | None = None
    status: int | None = None
    output: str = ""


class Case(NamedTuple):
    """What was known on a machine, and what was found."""

    name: str
    facts: Json
    findings: list[Json]


def found_in(facts: Facts) -> list[Json]:
    """Judge facts: level, id, parameters and next command of every finding."""
    return [to_json((each.level, each.id, dict(each.parameters), each.next)) for each in findings(facts)]


def read_cases() -> list[Case]:
    return [Case(**json.loads(line)) for line in RECORDED.read_text(encoding="utf-8").splitlines()]


def write_cases(cases: Sequence[Case]) -> None:
    lines = [json.dumps(case._asdict(), ensure_ascii=False, sort_keys=True) for case in sorted(cases)]
    RECORDED.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")


def recorded(name: str, facts: Facts, home: Path) -> Case:
    """Write facts down so that they are the same on every machine, with what rules find in them then.

    Raises ValueError where that is something else than they find in the facts themselves.
    """
    facts = dataclasses.replace(facts, pace=facts.speed)  # this computer was too slow or not: no matter of the case
    told = _same_everywhere(to_json(_timeless(facts)), home)
    found = found_in(facts_of(told))
    before, after = ([each[1] for each in each_found] for each_found in (found_in(facts), found))
    if before != after:
        raise ValueError(f"{name}: {before} was found, {after} in what was written down")
    return Case(name, told, found)


def facts_of(told: Json) -> Facts:
    found: Facts = _from_json(told, Facts)
    return found


# -- the same everywhere ---------------------------------------------------------------------------------------------------


def _timeless(facts: Facts) -> Facts:
    """The same facts at `NOW_NS`, of processes with the numbers 1, 2, …, with what rules look at of terminals."""
    shift = NOW_NS - facts.now_ns

    def shifted(time_ns: int | None) -> int | None:
        return None if time_ns is None else round(time_ns + shift, -8)

    def stamps(text: str) -> str:
        return re.sub(r"\[(\d{9,10}\.\d+)\]", lambda match: f"[{round(float(match[1]) + shift / 1e9, 1):.9f}]", text)

    terminals = tuple(
        each._replace(
            variables={name: each.variables[name] for name in VARIABLES if name in each.variables},
            lines=[
                Ran(
                    line.number,
                    line.source,
                    line.cwd,
                    shifted(line.began_ns) or 0,
                    shifted(line.ended_ns),
                    line.status,
                    stamps(plain(line.output[-LONGEST:])),
                )
                for line in list(each.lines)[-LAST_LINES:]
            ],
            version=0,
        )
        for each in facts.terminals or ()
    )
    processes = tuple(
        each._replace(zid=f"{number}", pid=number)
        for number, each in enumerate(sorted(facts.processes, key=_sorting), 1)
    )
    return dataclasses.replace(facts, now_ns=NOW_NS, terminals=terminals, processes=processes)


def _sorting(process: Any) -> tuple[Any, ...]:
    return process.arguments, [each.node for each in process.nodes]


def _same_everywhere(told: Json, home: Path) -> Json:
    places = {str(home): HOME, str(ROOT): INSTALLED, sys.prefix: "/usr", sys.base_prefix: "/usr"}
    if isinstance(told, str):
        for place in sorted(places, key=len, reverse=True):
            told = told.replace(place, places[place])
        for pattern, same in NUMBERS:
            told = re.sub(pattern, same, told)
        return told
    if isinstance(told, float):
        return round(told, 3)
    if isinstance(told, dict):
        return {_same_everywhere(key, home): _same_everywhere(value, home) for key, value in told.items()}
    return [_same_everywhere(each, home) for each in told] if isinstance(told, list) else told


# -- plain data to JSON and back --------------------------------------------------------------------------------------------


def to_json(value: Any) -> Json:
    """Fields by name, without those that have their default."""
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, Mapping):
        return {str(key): to_json(each) for key, each in value.items()}
    if isinstance(value, (frozenset, set)):
        return sorted(map(to_json, value))
    defaults = _defaults(type(value))
    if defaults is not None:
        pairs = ((name, getattr(value, name)) for name in get_type_hints(type(value)))
        return {name: to_json(each) for name, each in pairs if name not in defaults or each != defaults[name]}
    return [to_json(each) for each in value] if isinstance(value, (tuple, list)) else value


def _defaults(kind: type) -> Mapping[str, Any] | None:
    """The fields of a dataclass or named tuple that have a default; None for other types."""
    if dataclasses.is_dataclass(kind):
        made = {}
        for each in dataclasses.fields(kind):
            if each.default_factory is not dataclasses.MISSING:
                made[each.name] = each.default_factory()
            elif each.default is not dataclasses.MISSING:
                made[each.name] = each.default
        return made
    return getattr(kind, "_field_defaults", None)


def _from_json(told: Json, kind: Any) -> Any:
    if kind is RunLine:
        kind = Ran
    origin, of = get_origin(kind), get_args(kind)
    if origin in (Union, types.UnionType):
        (kind,) = (each for each in of if each is not type(None))
        return None if told is None else _from_json(told, kind)
    if origin is tuple and of[-1] is not Ellipsis:
        return tuple(_from_json(each, one) for each, one in zip(told, of, strict=True))
    if origin in (tuple, frozenset):
        return origin(_from_json(each, of[0]) for each in told)
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return {_from_json(key, of[0]): _from_json(each, of[1]) for key, each in told.items()}
    if isinstance(origin, type) and issubclass(origin, Sequence):
        return [_from_json(each, of[0]) for each in told]
    if _defaults(kind) is not None:
        hints = get_type_hints(kind)
        return kind(**{name: _from_json(each, hints[name]) for name, each in told.items()})
    return told if kind is object else kind(told)
