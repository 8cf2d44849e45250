"""Reads hidden scenarios (writing/en.md, "Hidden scenarios"): what is prepared, what runs the pupil's program, what must hold.

The values in them (`@name@`) are drawn anew for every grading, the same ones for all submissions.
"""

from __future__ import annotations

import random
import string
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from day6_core.language import LANGUAGES
from day6_core.lessons.actions import action_mistake, filled
from day6_core.lessons.checks import Condition, condition_of
from day6_core.lessons.document import Action
from day6_core.lessons.flaws import line_of, meant
from day6_core.lessons.grading.limits import ANSWER_SECONDS, BUILD_SECONDS, ENDING_SECONDS, START_SECONDS
from day6_core.lessons.lag import STALL
from day6_core.lessons.player import LONGEST_WAIT
from day6_core.lessons.source import NAME, LessonSource

HERE = Path(__file__).parent / "hidden"
WITHIN, MOST_WITHIN = 15.0, 60.0
ACTIONS = {"start": {"program"}, "publish": {"topic", "type", "fields"}, "call": {"service", "type"}, "build": set()}
"""Actions that only scenarios have, done by the grader itself, and what each needs."""

_OPTIONAL = {"start": {"arguments"}, "publish": {"count", "every"}, "call": {"fields"}, "build": set()}
_HEAD, _KEYS = (
    {"grading", "order", "title"},
    {"values", "files", "before", "run", "check", "must", "within", "needs", "stall"},
)


def is_played(lesson: str) -> bool:
    """Whether there are hidden scenarios for this lesson."""
    return (HERE / f"{lesson}.md").is_file()


@dataclass(frozen=True)
class Scenario:
    """One of them, as it stands in its file: `@name@` is filled in by `drawn`."""

    name: str
    line: int
    title: Mapping[str, str]
    values: Mapping[str, Any] = field(default_factory=dict)
    files: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Names for files of the submission: the first of the patterns (below the home folder) that is there."""
    before: tuple[Action, ...] = ()
    run: tuple[Action, ...] = ()
    check: tuple[Any, ...] = ()
    within: float = WITHIN
    needs: tuple[str, ...] = ()
    must: tuple[str, ...] = field(default=(), repr=False)
    """Names of checks; without one of each that holds there are no points."""

    stall: float = field(default=STALL, repr=False)
    """Seconds for which a busy machine may hold it up without making wrong what is right."""

    @property
    def longest(self) -> float:
        """The most seconds that it can take on a machine that keeps up."""
        actions = [item for action in (*self.before, *self.run) for item in action.items()]
        return sum(_longest(*item) for item in actions) + self.within + 2 * ENDING_SECONDS

    def drawn(self, seed: str) -> dict[str, Any]:
        """The values for one grading."""
        chance = random.Random(f"{seed}/{self.name}")
        return {name: _draw(kind, chance) for name, kind in self.values.items()}


@dataclass(frozen=True)
class Grading:
    """The scenarios of one lesson."""

    lesson: str
    path: Path
    order: int
    title: Mapping[str, str]
    scenarios: tuple[Scenario, ...]


def longest(found: Iterable[Grading]) -> float:
    """The most seconds that all their scenarios can take."""
    return START_SECONDS + sum(scenario.longest for grading in found for scenario in grading.scenarios)


def _longest(action: str, given: Any) -> float:
    if action == "publish":
        return ANSWER_SECONDS + float(given.get("every", 0.2)) * int(given.get("count", 1))
    if action == "pause":
        return float(given)
    return {"wait": ANSWER_SECONDS, "call": 2 * ANSWER_SECONDS, "build": BUILD_SECONDS}.get(action, LONGEST_WAIT)


def _draw(kind: Any, chance: random.Random) -> Any:
    if kind == "word":
        return "".join(chance.choices(string.ascii_lowercase, k=10))
    if kind == "name":
        return "n" + "".join(chance.choices(string.ascii_lowercase, k=7))
    if isinstance(kind, dict):
        return chance.choice(kind["choose"])
    low, high = kind
    if isinstance(low, int) and isinstance(high, int):
        return chance.randint(low, high)
    return round(chance.uniform(low, high), 2)


def gradings(folder: Path | None = None) -> list[Grading]:
    """All scenarios of a folder, those that come with the program by default. Raises LessonMistakes, OSError."""
    found = [read_grading(path) for path in sorted((folder or HERE).glob("*.md")) if path.name.lower() != "readme.md"]
    return sorted(found, key=lambda each: (each.order, each.lesson))


def read_grading(path: Path, data: bytes | None = None) -> Grading:
    """Read one file, or the `data` of one. Raises LessonMistakes, or OSError where there is none."""
    return _Reader(LessonSource(path, data)).grading()


class _Reader:
    def __init__(self, source: LessonSource) -> None:
        self._source = source
        self._wrong = source.wrong

    def grading(self) -> Grading:
        head, begin = self._source.front_matter("grading")
        self._source.judge_keys(head, _HEAD, 1)
        if not isinstance(head.get("grading"), str) or not NAME.match(head["grading"]):
            self._wrong(1, "'grading' has to be the name of a lesson")
        if not isinstance(head.get("order", 0), int):
            self._wrong(1, "'order' has to be a whole number")
        title = self._source.title(head)
        scenarios = self._scenarios(begin)
        self._source.judge_parts(scenarios, "scenario")
        self._source.judge()
        return Grading(head["grading"], self._source.path, head.get("order", 0), title, tuple(scenarios))

    def _scenarios(self, begin: int) -> list[Scenario]:
        """Cut the file into scenarios: a name, one yaml block, a title in each language."""
        found: list[Scenario] = []
        name, line, data, data_line, titles = "", 0, None, 0, {}  # type: ignore[var-annotated]
        at, lines = begin, self._source.lines
        while at <= len(lines):
            text = lines[at] if at < len(lines) else "# "
            if text.startswith("# "):
                if name:
                    found.append(self._scenario(name, line, data, data_line, titles))
                name, line, data, titles = text[2:].strip(), at + 1, None, {}
            elif text.strip() in ("~~~yaml", "```yaml"):
                fence = text.strip()[:3]
                end = next(
                    (row for row in range(at + 1, len(lines)) if lines[row].strip() == fence),
                    None,
                )
                if end is None:
                    self._wrong(at + 1, "this block is not closed")
                    break
                data, data_line = self._source.yaml("\n".join(lines[at + 1 : end]), at + 2), at + 2
                at = end
            elif text.startswith("## "):
                language, _, title = text[3:].strip().partition(" ")
                if language not in LANGUAGES or not title.strip():
                    self._wrong(at + 1, "expected '## zh TITLE' or '## en TITLE'")
                titles[language] = title.strip()
            at += 1
        return found

    def _scenario(self, name: str, line: int, data: dict[str, Any] | None, at: int, titles: dict[str, str]) -> Scenario:
        if not NAME.match(name):
            self._wrong(line, f"'{name}': the name of a scenario is of letters a-z, digits, '_' and '-'")
        for language in LANGUAGES:
            if language not in titles:
                self._wrong(line, f"'## {language} TITLE' is missing")
        data = {} if data is None else data
        at = at or line
        self._source.judge_keys(data, _KEYS, at)
        values = self._values(data.get("values") or {}, at)
        files = self._files(data.get("files") or {}, at)
        known = {**{key: _draw(kind, random.Random(0)) for key, kind in values.items()}, **dict.fromkeys(files, "~/f")}
        lists = {key: self._list(data, key, at, known) for key in ("before", "run", "check", "needs", "must")}
        for key in ("before", "run"):
            for action in lists[key]:
                if mistake := scenario_action_mistake(self._tried(action, known)):
                    self._source.flaw(line_of(action) or at, key, mistake)
        for given in lists["check"]:
            made = condition_of(self._tried(given, known))
            if not isinstance(made, Condition):
                self._source.flaw(line_of(given) or at, "check", made)
        used = [next(iter(each), "") for each in lists["check"] if isinstance(each, dict)]
        for each in lists["must"]:
            if each not in used:
                self._wrong(at, f"must: there is no '{each}' among the checks{meant(each, used)}")
        if not lists["check"] and not getattr(data, "broken", False):
            self._wrong(line, f"the scenario '{name}' checks nothing")
        within = self._seconds(data, "within", WITHIN, at)
        stall = self._seconds(data, "stall", STALL, at)
        return Scenario(
            name, line, titles, values, files, tuple(lists["before"]), tuple(lists["run"]), tuple(lists["check"]),
            within, tuple(map(str, lists["needs"])), tuple(map(str, lists["must"])), stall,
        )  # fmt: skip

    def _seconds(self, data: dict[str, Any], key: str, default: float, line: int) -> float:
        given = data.get(key, default)
        if isinstance(given, bool) or not isinstance(given, (int, float)) or not 0 < given <= MOST_WITHIN:
            self._wrong(line, f"{key}: a number of seconds up to {MOST_WITHIN:g}")
            return default
        return float(given)

    @staticmethod
    def _tried(given: Any, known: dict[str, Any]) -> Any:
        try:
            return filled(given, known)
        except KeyError:
            return given  # told already

    def _list(self, data: dict[str, Any], key: str, line: int, known: dict[str, Any]) -> list[Any]:
        found = self._source.list(data, key, line)
        try:
            filled(found, known)
        except KeyError as unknown:
            self._wrong(line, f"{key}: @{unknown.args[0]}@ is neither in 'values' nor in 'files'")
        return found

    def _values(self, given: Any, line: int) -> dict[str, Any]:
        found = {}
        for name, kind in given.items() if isinstance(given, dict) else ():
            numbers = isinstance(kind, list) and len(kind) == 2 and all(
                isinstance(each, (int, float)) and not isinstance(each, bool) for each in kind
            )  # fmt: skip
            choice = isinstance(kind, dict) and kind.keys() == {"choose"} and isinstance(kind["choose"], list)
            if kind in ("word", "name") or (numbers and kind[0] <= kind[1]) or (choice and kind["choose"]):
                found[str(name)] = kind
            else:
                self._wrong(line, f"values: '{name}' is 'word', 'name', [lowest, highest] or {{choose: [...]}}")
        if not isinstance(given, dict):
            self._wrong(line, "values: 'name: kind' lines")
        return found

    def _files(self, given: Any, line: int) -> dict[str, tuple[str, ...]]:
        found = {}
        for name, patterns in given.items() if isinstance(given, dict) else ():
            listed = [patterns] if isinstance(patterns, str) else patterns
            good = isinstance(listed, list) and listed and all(isinstance(each, str) for each in listed)
            if not good or any(".." in each or not each.startswith("~/") for each in listed):
                self._wrong(line, f"files: '{name}' needs patterns that begin with '~/'")
            else:
                found[str(name)] = tuple(listed)
        if not isinstance(given, dict):
            self._wrong(line, "files: 'name: pattern' lines")
        return found


def scenario_action_mistake(given: object) -> str:
    """What is wrong with an action of a scenario; '' if nothing is."""
    if not isinstance(given, dict) or len(given) != 1 or next(iter(given)) not in ACTIONS:
        return action_mistake(given)
    name, value = next(iter(given.items()))
    if name == "build":
        return "" if isinstance(value, str) else "build: the name of a package"
    if name == "start" and isinstance(value, str):
        value = {"program": value}
    if not isinstance(value, dict) or ACTIONS[name] - value.keys() or value.keys() - ACTIONS[name] - _OPTIONAL[name]:
        return f"{name}: needs {' and '.join(sorted(ACTIONS[name]))}, may have {', '.join(sorted(_OPTIONAL[name]))}"
    if name == "start" and len(str(value["program"]).split()) != 2:
        return "start: 'PACKAGE EXECUTABLE' of a program that comes with day6-tui"
    return ""
