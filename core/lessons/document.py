"""Reads a lesson file (`WRITING.md`): front matter, steps with their checks and actions, and the texts in both languages.

Every mistake is collected with its line, so that a teacher mends them in one go.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import yaml

from day6_tui.core.lessons.actions import action_mistake
from day6_tui.core.lessons.checks import Condition, condition_of
from day6_tui.core.width import text_width

LANGUAGES = ("zh", "en")
PARTS = ("do", "hints", "answers", "teacher")
PICTURE_LINES, PICTURE_COLUMNS = 9, 34
HINTS = 3
LARGEST = 1_000_000
"""Bytes of a lesson file."""

_NAME = re.compile(r"[a-z0-9][a-z0-9_-]*\Z")
_FENCE = re.compile(r"(~~~+|```+)\s*(\w*)\s*\Z")
_HEAD = {"lesson", "drill", "order", "minutes", "title", "fault", "topic"}
_STEP = {"check", "solve", "wrong", "needs", "before", "command"}
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
_HINT = re.compile(r"\d+\.\s+(.*)\Z")
_ANSWER = re.compile(r"-\s+([a-z]):\s+(.*?)(?:\s*\|\s*(.*))?\Z")


@dataclass(frozen=True)
class Mistake:
    """What is wrong with a lesson file, and where (line from 1)."""

    line: int
    text: str


class LessonMistakes(Exception):
    """A lesson file that cannot be used."""

    def __init__(self, path: Path, mistakes: list[Mistake]) -> None:
        self.path = path
        self.mistakes = sorted(mistakes, key=lambda each: each.line)
        super().__init__("\n".join(f"{path.name}:{each.line}: {each.text}" for each in self.mistakes))


Action = Mapping[str, Any]
"""One action: a dictionary with one key."""


@dataclass(frozen=True)
class Answer:
    """A choice of a question."""

    letter: str
    text: str
    reason: str = ""


@dataclass(frozen=True)
class Page:
    """A step's texts in one language; `body` and `do` are Markdown as WRITING.md describes it."""

    title: str
    picture: tuple[str, ...] = ()
    body: str = ""
    do: str = ""
    hints: tuple[str, ...] = ()
    answers: tuple[Answer, ...] = ()
    teacher: str = ""


@dataclass(frozen=True)
class Wrong:
    """A tempting wrong answer: what is done, part of the message that refuses it, how to clear it away."""

    do: tuple[Action, ...]
    says: str
    undo: tuple[Action, ...] = ()


@dataclass(frozen=True)
class Step:
    """One step of a lesson."""

    name: str
    line: int
    checks: tuple[Condition, ...] = ()
    solve: tuple[Action, ...] = ()
    wrong: tuple[Wrong, ...] = ()
    needs: tuple[str, ...] = ()
    before: tuple[Action, ...] = ()
    command: str = ""
    pages: Mapping[str, Page] = field(default_factory=dict)


@dataclass(frozen=True)
class Lesson:
    """A whole file: a lesson or, with `fault`, a drill."""

    name: str
    path: Path
    order: int
    minutes: int
    title: Mapping[str, str]
    steps: tuple[Step, ...]
    is_drill: bool = False
    fault: int = 0
    topic: str = ""

    def step(self, name: str) -> Step | None:
        return next((step for step in self.steps if step.name == name), None)


def read_lesson(path: Path) -> Lesson:
    """Read a lesson. Raises LessonMistakes, or OSError where there is no such file."""
    if path.stat().st_size > LARGEST:
        raise LessonMistakes(path, [Mistake(1, f"the file is larger than {LARGEST} bytes")])
    try:
        text = path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise LessonMistakes(
            path, [Mistake(1, f"the file is not UTF-8 ({error.reason} at byte {error.start})")]
        ) from None
    return _Reader(path, text).lesson()


class _Reader:
    def __init__(self, path: Path, text: str) -> None:
        self._path = path
        self._lines = text.replace("\r\n", "\n").split("\n")
        self._mistakes: list[Mistake] = []

    def _wrong(self, line: int, text: str) -> None:
        self._mistakes.append(Mistake(line, text))

    def lesson(self) -> Lesson:
        for number, line in enumerate(self._lines, 1):
            if _CONTROL.search(line):
                self._wrong(number, "a control character: it could disturb the terminal")
        head, begin = self._front_matter()
        steps = [self._step(*each) for each in self._sections(begin)]
        if not steps:
            self._wrong(len(self._lines), "there is no step: a step begins with '# name'")
        names = [step.name for step in steps]
        for index, step in enumerate(steps):
            if step.name in names[:index]:
                self._wrong(step.line, f"there are two steps '{step.name}'")
            for needed in step.needs:
                if needed not in names[:index]:
                    self._wrong(step.line, f"needs: no earlier step is called '{needed}'")
        lesson = self._lesson_of(head, steps)
        if self._mistakes:
            raise LessonMistakes(self._path, self._mistakes)
        return lesson

    def _lesson_of(self, head: dict[str, Any], steps: list[Step]) -> Lesson:
        for key in head.keys() - _HEAD:
            self._wrong(1, f"unknown key '{key}'; there are {', '.join(sorted(_HEAD))}")
        drill = "drill" in head
        name = head.get("drill" if drill else "lesson")
        if not isinstance(name, str) or not _NAME.match(name):
            self._wrong(1, "'lesson' (or 'drill') has to be a name of letters a-z, digits, '_' and '-'")
        title = head.get("title")
        if not isinstance(title, dict) or any(not isinstance(title.get(each), str) for each in LANGUAGES):
            self._wrong(1, "'title' needs a text for 'zh' and for 'en'")
            title = {}
        numbers = {}
        for key, least in (("order", 0), ("minutes", 1), ("fault", 0)):
            value = head.get(key, least)
            if not isinstance(value, int) or isinstance(value, bool) or value < least:
                self._wrong(1, f"'{key}' has to be a whole number from {least} on")
                value = least
            numbers[key] = value
        if drill and len(steps) != 1:
            self._wrong(1, f"a drill has one step, not {len(steps)}")
        return Lesson(
            str(name), self._path, numbers["order"], numbers["minutes"], title, tuple(steps), drill,
            numbers["fault"], str(head.get("topic", "")),
        )  # fmt: skip

    def _front_matter(self) -> tuple[dict[str, Any], int]:
        lines = self._lines
        if lines[0].strip() != "---":
            self._wrong(1, "the file has to begin with '---', then 'lesson: NAME' …, then '---'")
            return {}, 0
        end = next((at for at, line in enumerate(lines[1:], 1) if line.strip() == "---"), None)
        if end is None:
            self._wrong(1, "the '---' that ends the front matter is missing")
            return {}, len(lines)
        return self._yaml("\n".join(lines[1:end]), 2), end + 1

    def _yaml(self, text: str, line: int) -> dict[str, Any]:
        try:
            found = yaml.safe_load(text)
        except yaml.YAMLError as error:
            mark = getattr(error, "problem_mark", None)
            problem = getattr(error, "problem", None) or str(error).splitlines()[0]
            self._wrong(line + (mark.line if mark is not None else 0), f"not YAML: {problem}")
            return {}
        except (ValueError, RecursionError) as error:  # a date that does not exist; a thousand brackets
            self._wrong(line, f"not YAML: {str(error).splitlines()[0]}")
            return {}
        if found is None:
            return {}
        if not isinstance(found, dict):
            self._wrong(line, "expected 'key: value' lines")
            return {}
        return {str(key): value for key, value in found.items()}

    def _sections(self, begin: int) -> list[tuple[str, int, list[str]]]:
        """The steps: name, number of the line with the name, lines below."""
        found: list[tuple[str, int, list[str]]] = []
        fence = ""
        for at, line in enumerate(self._lines[begin:], begin):
            mark = _FENCE.match(line)
            if fence:
                if mark is not None and line.strip().startswith(fence) and not mark[2]:
                    fence = ""
            elif mark is not None:
                fence = mark[1][:3]
            elif line.startswith("# "):
                found.append((line[2:].strip(), at + 1, []))
                continue
            if found:
                found[-1][2].append(line)
            elif line.strip():
                self._wrong(at + 1, "text before the first step ('# name')")
        if fence:
            self._wrong(len(self._lines), f"a block that began with {fence} is not closed")
        return found

    # -- one step ------------------------------------------------------------------------------------------------------

    def _step(self, name: str, line: int, lines: list[str]) -> Step:
        if not _NAME.match(name):
            self._wrong(line, f"'{name}': the name of a step is of letters a-z, digits, '_' and '-'")
        blocks = _blocks(lines, line + 1)
        data: dict[str, Any] = {}
        data_line = line
        pages: dict[str, Page] = {}
        language = ""
        page: Page | None = None
        part = ""
        for block in blocks:
            if block.kind == "yaml" and not language:
                data_line = block.line
                data = self._yaml(block.text, block.line)
            elif block.kind == "##":
                language, _, title = block.text.partition(" ")
                part = ""
                if language not in LANGUAGES or language in pages:
                    self._wrong(
                        block.line, f"expected '## zh TITLE' or '## en TITLE', once each, not '## {block.text}'"
                    )
                if not title.strip():
                    self._wrong(block.line, f"'## {language}' has no title")
                page = pages[language] = Page(title.strip())
            elif page is None:
                if block.text.strip():
                    self._wrong(block.line, "only a yaml block may stand before '## zh'")
            elif block.kind == "###":
                part = block.text.strip()
                if part not in PARTS:
                    self._wrong(block.line, f"unknown part '### {part}'; there are {', '.join(PARTS)}")
            else:
                page = pages[language] = self._with_block(page, part, block)
        step = self._step_of(name, line, data, data_line, pages)
        self._judge_pages(step)
        return step

    def _with_block(self, page: Page, part: str, block: _Block) -> Page:
        if block.kind == "picture" and not part:
            rows = tuple(block.text.split("\n")) if block.text else ()
            widest = max(map(text_width, rows), default=0)
            if len(rows) > PICTURE_LINES or widest > PICTURE_COLUMNS:
                self._wrong(
                    block.line,
                    f"the picture has {widest} columns, {len(rows)} lines; the most are {PICTURE_COLUMNS} and {PICTURE_LINES}",
                )
            return replace(page, picture=rows)
        text = f"```{block.kind}\n{block.text}\n```" if block.kind else block.text
        if part == "hints":
            return replace(page, hints=(*page.hints, *self._hints(block)))
        if part == "answers":
            return replace(page, answers=(*page.answers, *self._answers(block)))
        if part == "do":
            return replace(page, do=_joined(page.do, text))
        if part == "teacher":
            return replace(page, teacher=_joined(page.teacher, text))
        return replace(page, body=_joined(page.body, text))

    def _hints(self, block: _Block) -> list[str]:
        found: list[str] = []
        for number, line in enumerate(block.text.split("\n")):
            match = _HINT.match(line.strip())
            if match is not None:
                found.append(match[1])
            elif line.strip() and found:
                found[-1] += " " + line.strip()
            elif line.strip():
                self._wrong(block.line + number, "a hint begins with its number: '1. …'")
        return found

    def _answers(self, block: _Block) -> list[Answer]:
        found = []
        for number, line in enumerate(block.text.split("\n")):
            match = _ANSWER.match(line.strip())
            if match is not None:
                found.append(Answer(match[1], match[2], match[3] or ""))
            elif line.strip():
                self._wrong(block.line + number, "an answer is '- a: TEXT | REASON'")
        return found

    def _step_of(self, name: str, line: int, data: dict[str, Any], at: int, pages: dict[str, Page]) -> Step:
        for key in data.keys() - _STEP:
            self._wrong(at, f"unknown key '{key}'; there are {', '.join(sorted(_STEP))}")
        checks = []
        given = self._list(data, "check", at)
        if not given:
            self._wrong(line, f"step '{name}' checks nothing")
        for each in given:
            made = condition_of(each)
            if isinstance(made, str):
                self._wrong(at, f"check: {made}")
            else:
                checks.append(made)
        wrong = []
        for each in self._list(data, "wrong", at):
            if (
                not isinstance(each, dict)
                or not isinstance(each.get("says"), str)
                or each.keys() - {"do", "says", "undo"}
            ):
                self._wrong(at, "wrong: each needs 'do' (actions) and 'says' (a text), and may have 'undo'")
                continue
            wrong.append(Wrong(self._actions(each, "do", at), each["says"], self._actions(each, "undo", at)))
        needs = self._list(data, "needs", at)
        solve = self._actions(data, "solve", at)
        typed = next((str(each["type"]).strip().split("\n")[0] for each in solve if "type" in each), "")
        return Step(
            name,
            line,
            tuple(checks),
            solve,
            tuple(wrong),
            tuple(map(str, needs)),
            self._actions(data, "before", at),
            str(data.get("command", typed)),
            pages,
        )

    def _list(self, data: dict[str, Any], key: str, line: int) -> list[Any]:
        found = data.get(key)
        if found is None:
            return []
        if not isinstance(found, list):
            self._wrong(line, f"'{key}' has to be a list: lines that begin with '- '")
            return []
        return found

    def _actions(self, data: dict[str, Any], key: str, line: int) -> tuple[Action, ...]:
        found = []
        for each in self._list(data, key, line):
            mistake = action_mistake(each)
            if mistake:
                self._wrong(line, f"{key}: {mistake}")
            else:
                found.append(each)
        return tuple(found)

    def _judge_pages(self, step: Step) -> None:
        asked = next((check for check in step.checks if check.name == "answer"), None)
        for language in LANGUAGES:
            page = step.pages.get(language)
            if page is None:
                self._wrong(step.line, f"step '{step.name}' has no '## {language}' part")
                continue
            if not page.body.strip():
                self._wrong(step.line, f"step '{step.name}', {language}: there is no text")
            if not page.do.strip():
                self._wrong(step.line, f"step '{step.name}', {language}: '### do' is missing or empty")
            if len(page.hints) != HINTS:
                self._wrong(
                    step.line, f"step '{step.name}', {language}: {HINTS} hints are needed, there are {len(page.hints)}"
                )
            letters = [answer.letter for answer in page.answers]
            if asked is not None and asked.arguments["letter"] not in letters:
                self._wrong(
                    step.line, f"step '{step.name}', {language}: '### answers' has no '{asked.arguments['letter']}'"
                )


@dataclass(frozen=True)
class _Block:
    """A run of lines: kind '' (text), '##' or '###' (a heading), or the word after a fence."""

    kind: str
    line: int
    text: str


def _blocks(lines: list[str], first: int) -> list[_Block]:
    found: list[_Block] = []
    text: list[str] = []
    begin = first
    fence = kind = ""

    def finish(kind: str) -> None:
        if kind or any(line.strip() for line in text):
            found.append(_Block(kind, begin, "\n".join(text).strip("\n")))
        text.clear()

    for number, line in enumerate(lines, first):
        mark = _FENCE.match(line)
        if fence:
            if mark is not None and line.strip().startswith(fence) and not mark[2]:
                finish(kind or "text")
                fence, begin = "", number + 1
            else:
                text.append(line)
        elif mark is not None:
            finish("")
            fence, kind, begin = mark[1][:3], mark[2], number + 1
        elif line.startswith(("## ", "### ")):
            finish("")
            hashes, _, rest = line.partition(" ")
            found.append(_Block(hashes, number, rest.strip()))
            begin = number + 1
        else:
            if not text:
                begin = number
            text.append(line)
    finish("")
    return found


def _joined(before: str, text: str) -> str:
    return f"{before}\n\n{text.strip(chr(10))}" if before else text.strip("\n")
