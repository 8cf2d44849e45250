"""The named checks of lessons: a table of functions, what a lesson file may write for them, and their verdicts.

A check is a function `name(live, arguments…) -> Verdict` in one of the modules here. Its parameters are what writing/en.md
documents: names, types and defaults are read from the signature. It looks at `Live` and changes nothing.
"""

from __future__ import annotations

import inspect
import logging
import re
import reprlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, TypeVar

from day6_core.lessons.flaws import Flaw, line_of, meant, path_flaw
from day6_core.lessons.texts import Say
from day6_core.reason import fault

if TYPE_CHECKING:
    from day6_core.lessons.live import Live

_log = logging.getLogger(__name__)

MODULES = ("graph", "messages", "commands", "terminals", "files", "robot", "drawing", "judged", "hidden")
COMBINERS = ("any", "all", "not")


@dataclass(frozen=True)
class Verdict:
    """Whether a check holds, what it wants, and what it saw instead."""

    ok: bool
    wanted: Say
    saw: Say | None = None
    broken: bool = False
    """Whether the check itself failed, so that nothing is known."""
    where: Say | None = None
    """Where the two differ first, with what was to be there and what is."""
    part: float = 0.0
    """How much of it is done, 0 to 1, where that can be told."""
    going: bool = False
    """Whether what is there is right and more is coming: given more time it may hold."""
    cheated: bool = False
    """Whether what was seen came about in a way that the check rules out."""

    def text(self, language: str) -> str:
        """Both in one line."""
        saw = f" {self.saw.text(language)}" if self.saw is not None else ""
        return self.wanted.text(language) + saw


Check = Callable[..., Verdict]


@dataclass(frozen=True)
class CheckKind:
    """A named check: its function and parameters. `event`: once it was so it stays so.

    `patterns`, `names` and `paths` are the parameters that are regular expressions, full names of the graph, and places in the
    home folder; `one_of` are those that have only a few values.
    """

    name: str
    function: Check
    parameters: Mapping[str, inspect.Parameter]
    event: bool = False
    patterns: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    paths: tuple[str, ...] = ()
    one_of: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    @property
    def first(self) -> str:
        """The parameter that a bare value is given to."""
        return next(iter(self.parameters))


_KINDS: dict[str, CheckKind] = {}
AnyCheck = TypeVar("AnyCheck", bound=Check)


def check(
    name: str,
    *,
    event: bool = False,
    patterns: tuple[str, ...] = (),
    names: tuple[str, ...] = (),
    paths: tuple[str, ...] = (),
    one_of: Mapping[str, tuple[str, ...]] | None = None,
) -> Callable[[AnyCheck], AnyCheck]:
    """Make a function the check of this name; see CheckKind."""

    def register(function: AnyCheck) -> AnyCheck:
        found = inspect.signature(function).parameters
        # `from` is a word of Python: a parameter `from_` is written `from` in a lesson.
        parameters = {each.rstrip("_"): parameter for each, parameter in found.items() if each != "live"}
        _KINDS[name] = CheckKind(name, function, parameters, event, patterns, names, paths, one_of or {})
        return function

    return register


@lru_cache(maxsize=1)
def kinds() -> Mapping[str, CheckKind]:
    """All named checks."""
    for module in MODULES:
        import_module(f"{__name__}.{module}")
    return dict(sorted(_KINDS.items()))


@dataclass(frozen=True)
class Condition:
    """One check of a step with its arguments; `parts` are those that `any`, `all` and `not` combine."""

    name: str
    arguments: Mapping[str, Any] = field(default_factory=dict)
    parts: tuple[Condition, ...] = ()
    once: bool = False
    line: int = field(default=0, compare=False)
    """Where it stands in its file."""

    def judge(self, live: Live) -> Verdict:
        """Look whether it holds now. What a check remembers is kept in `live` for this step."""
        memory = live.memory(self)
        if "held" in memory:
            held: Verdict = memory["held"]
            return held
        verdict = self._combined(live) if self.parts else self._asked(live, memory)
        if verdict.ok and (self.once or (not self.parts and kinds()[self.name].event)):
            memory["held"] = verdict
        return verdict

    def _asked(self, live: Live, memory: dict[str, Any]) -> Verdict:
        kind = kinds()[self.name]
        live.remembered = memory
        try:
            return kind.function(live, **{kind.parameters[key].name: value for key, value in self.arguments.items()})
        except Exception as error:
            # A check that fails must not take the lesson with it; the pupil is told that nothing is known.
            _log.warning("the check %s of a lesson failed", self.name, exc_info=True)
            return Verdict(
                False,
                Say("check.failed", name=self.name, reason=fault(error)),
                broken=True,
            )

    def _combined(self, live: Live) -> Verdict:
        verdicts = [part.judge(live) for part in self.parts]
        if self.name == "not":
            inner = verdicts[0]
            return Verdict(
                not inner.ok and not inner.broken, Say("check.not", inner=inner.wanted), inner.saw, inner.broken
            )
        if self.name == "any":
            best = next((each for each in verdicts if each.ok), None)
            if best is not None:
                return best
            first = verdicts[0]
            alike = all(part.name == self.parts[0].name for part in self.parts)  # other ways to do the same
            wanted = first.wanted if alike else Say("check.any", inner=tuple(each.wanted for each in verdicts))
            return Verdict(False, wanted, first.saw)
        worst = next((each for each in verdicts if not each.ok), None)
        return worst if worst is not None else verdicts[0]

    @property
    def is_event(self) -> bool:
        """Whether it is about something that happened, not about how things are."""
        return any(part.is_event for part in self.parts) if self.parts else kinds()[self.name].event

    def every(self) -> list[Condition]:
        """This one and all parts."""
        return [self, *(each for part in self.parts for each in part.every())]


def condition_of(given: object) -> Condition | Flaw:
    """Make a condition of what a lesson file says, or return what is wrong with it: a Flaw, with its line if that is known."""
    if not isinstance(given, dict) or not given:
        return Flaw(f"expected 'name: value', not {_shown(given)}", line_of(given))
    if len(given) != 1:
        names = ", ".join(map(str, given))
        told = f"one check has one name, but there are {names}: does the next '- ' or an indentation miss?"
        return Flaw(told, line_of(given, list(given)[1]))
    name, value = next(iter(given.items()))
    line = line_of(given, name)
    if name in COMBINERS:
        return _combination(str(name), value, line)
    kind = kinds().get(str(name))
    if kind is None:
        return Flaw(f"there is no check '{name}'{meant(name, [*kinds(), *COMBINERS])}", line)
    arguments = dict(value) if isinstance(value, dict) else {kind.first: value}
    once = arguments.pop("once", False)
    key, mistake = _judged(kind, arguments)
    if mistake:
        return Flaw(f"{kind.name}: {mistake}", line_of(value, key) or line)
    return Condition(kind.name, arguments, once=bool(once), line=line)


def _combination(name: str, value: object, line: int) -> Condition | Flaw:
    given = [value] if name == "not" else value
    if not isinstance(given, list) or not given:
        return Flaw(f"'{name}' combines a list of checks", line)
    parts = [condition_of(each) for each in given]
    flaw = next((part for part in parts if isinstance(part, Flaw)), None)
    if flaw is not None:
        return flaw.of(name, line)
    return Condition(name, {}, tuple(part for part in parts if isinstance(part, Condition)), line=line)


def _judged(kind: CheckKind, arguments: dict[str, Any]) -> tuple[str, str]:
    """The argument that is wrong, and what is wrong with it; numbers and texts are made what the check wants."""
    for key in arguments:
        if key not in kind.parameters:
            return str(key), f"unknown argument '{key}'{meant(key, kind.parameters)}"
    for name, parameter in kind.parameters.items():
        if name not in arguments:
            if parameter.default is inspect.Parameter.empty:
                return name, f"the argument '{name}' is missing"
            continue
        mistake = _typed(name, str(parameter.annotation), arguments) or _valued(kind, name, arguments[name])
        if mistake:
            return name, mistake
    return "", ""


def _typed(name: str, wanted: str, arguments: dict[str, Any]) -> str:
    value = arguments[name]
    if wanted.startswith("float"):
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            return f"'{name}' has to be a number, not {_shown(value)}"
        arguments[name] = float(value)
    elif wanted.startswith("int") and (isinstance(value, bool) or not isinstance(value, int)):
        return f"'{name}' has to be a whole number, not {_shown(value)}"
    elif wanted.startswith("str") and not isinstance(value, str):
        return f"'{name}' has to be a text, not {_shown(value)} (quote it)"
    elif wanted.startswith("list"):
        if not isinstance(value, list):
            return f"'{name}' has to be a list: [a, b]"
        arguments[name] = tuple(str(each) for each in value)
    elif wanted.startswith("bool") and not isinstance(value, bool):
        return f"'{name}' has to be true or false, not {_shown(value)}"
    return ""


def _valued(kind: CheckKind, name: str, value: Any) -> str:
    if not isinstance(value, str):
        return ""
    if name in kind.patterns:
        try:
            re.compile(value)
        except (re.error, OverflowError, RecursionError) as error:
            return f"'{name}' is not a regular expression: {error}; write '\\' before a sign that is meant as it is"
    if name in kind.names and not value.startswith("/"):
        return f"'{name}' is a full name: write /{value}"
    if name in kind.paths and path_flaw(value):
        return path_flaw(value)
    if name in kind.one_of and value not in kind.one_of[name]:
        return f"'{name}' cannot be '{value}'{meant(value, kind.one_of[name])}"
    return ""


def _shown(value: object) -> str:
    text = reprlib.repr(value)
    return text if len(text) <= 40 else text[:39] + "…"
