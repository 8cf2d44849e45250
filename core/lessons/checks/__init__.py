"""The named checks of lessons: a table of functions, what a lesson file may write for them, and their verdicts.

A check is a function `name(live, arguments…) -> Verdict` in one of the modules here. Its parameters are what WRITING.md
documents: names, types and defaults are read from the signature. It looks at `Live` and changes nothing.
"""

from __future__ import annotations

import inspect
import logging
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, TypeVar

from day6_tui.core.lessons.texts import Say

if TYPE_CHECKING:
    from day6_tui.core.lessons.live import Live

_log = logging.getLogger(__name__)

MODULES = ("graph", "messages", "terminals", "files", "robot", "drawing", "judged", "hidden")
COMBINERS = ("any", "all", "not")


@dataclass(frozen=True)
class Verdict:
    """Whether a check holds, what it wants, and what it saw instead."""

    ok: bool
    wanted: Say
    saw: Say | None = None
    broken: bool = False
    """Whether the check itself failed, so that nothing is known."""

    def text(self, language: str) -> str:
        """Both in one line."""
        saw = f" {self.saw.text(language)}" if self.saw is not None else ""
        return self.wanted.text(language) + saw


Check = Callable[..., Verdict]


@dataclass(frozen=True)
class CheckKind:
    """A named check: its function and parameters. `event`: once it was so it stays so; `patterns` names regular expressions."""

    name: str
    function: Check
    parameters: Mapping[str, inspect.Parameter]
    event: bool = False
    patterns: tuple[str, ...] = ()

    @property
    def first(self) -> str:
        """The parameter that a bare value is given to."""
        return next(iter(self.parameters))


_KINDS: dict[str, CheckKind] = {}
AnyCheck = TypeVar("AnyCheck", bound=Check)


def check(name: str, *, event: bool = False, patterns: tuple[str, ...] = ()) -> Callable[[AnyCheck], AnyCheck]:
    """Make a function the check of this name."""

    def register(function: AnyCheck) -> AnyCheck:
        found = inspect.signature(function).parameters
        # `from` is a word of Python: a parameter `from_` is written `from` in a lesson.
        parameters = {each.rstrip("_"): parameter for each, parameter in found.items() if each != "live"}
        _KINDS[name] = CheckKind(name, function, parameters, event, patterns)
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
                Say("check.failed", name=self.name, reason=f"{type(error).__name__}: {error}"),
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
            return Verdict(False, Say("check.any", inner=tuple(each.wanted for each in verdicts)), verdicts[0].saw)
        worst = next((each for each in verdicts if not each.ok), None)
        return worst if worst is not None else verdicts[0]

    @property
    def is_event(self) -> bool:
        """Whether it is about something that happened, not about how things are."""
        return any(part.is_event for part in self.parts) if self.parts else kinds()[self.name].event

    def every(self) -> list[Condition]:
        """This one and all parts."""
        return [self, *(each for part in self.parts for each in part.every())]


def condition_of(given: object) -> Condition | str:
    """Make a condition of what a lesson file says, or return what is wrong with it."""
    if not isinstance(given, dict) or not given:
        return f"expected 'name: value', not {_shown(given)}"
    if len(given) != 1:
        return f"one check has one name, but there are {', '.join(map(str, given))}: does the next '- ' or an indentation miss?"
    name, value = next(iter(given.items()))
    if name in COMBINERS:
        return _combination(str(name), value)
    kind = kinds().get(str(name))
    if kind is None:
        from difflib import get_close_matches

        near = get_close_matches(str(name), [*kinds(), *COMBINERS], 1)
        return f"there is no check '{name}'" + (f"; did you mean '{near[0]}'?" if near else "")
    arguments = dict(value) if isinstance(value, dict) else {kind.first: value}
    once = arguments.pop("once", False)
    mistake = _judged(kind, arguments)
    return mistake or Condition(kind.name, arguments, once=bool(once))


def _combination(name: str, value: object) -> Condition | str:
    given = [value] if name == "not" else value
    if not isinstance(given, list) or not given:
        return f"'{name}' combines a list of checks"
    parts = [condition_of(each) for each in given]
    mistake = next((part for part in parts if isinstance(part, str)), None)
    if mistake is not None:
        return f"{name}: {mistake}"
    return Condition(name, {}, tuple(part for part in parts if isinstance(part, Condition)))


def _judged(kind: CheckKind, arguments: dict[str, Any]) -> str:
    """What is wrong with the arguments; numbers and texts are made what the check wants."""
    for key in arguments:
        if key not in kind.parameters:
            return f"{kind.name}: unknown argument '{key}'; there are {', '.join(kind.parameters)}"
    for name, parameter in kind.parameters.items():
        if name not in arguments:
            if parameter.default is inspect.Parameter.empty:
                return f"{kind.name}: the argument '{name}' is missing"
            continue
        wanted, value = str(parameter.annotation), arguments[name]
        if wanted.startswith("float"):
            if isinstance(value, bool) or not isinstance(value, (int, float)):
                return f"{kind.name}: '{name}' has to be a number, not {_shown(value)}"
            arguments[name] = float(value)
        elif wanted.startswith("int") and (isinstance(value, bool) or not isinstance(value, int)):
            return f"{kind.name}: '{name}' has to be a whole number, not {_shown(value)}"
        elif wanted.startswith("str") and not isinstance(value, str):
            return f"{kind.name}: '{name}' has to be a text, not {_shown(value)} (quote it)"
        elif wanted.startswith("list"):
            if not isinstance(value, list):
                return f"{kind.name}: '{name}' has to be a list: [a, b]"
            arguments[name] = tuple(str(each) for each in value)
    for name in kind.patterns:
        if isinstance(pattern := arguments.get(name), str):
            try:
                re.compile(pattern)
            except (re.error, OverflowError, RecursionError) as error:
                return f"{kind.name}: '{name}' is no regular expression: {error}"
    return ""


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 40 else text[:39] + "…"
