"""Reads a lesson file (`writing/en.md`)."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from day6_core.language import LANGUAGES
from day6_core.lessons.actions import WINDOWS, action_mistake
from day6_core.lessons.blocks import Block, blocks
from day6_core.lessons.checks import Condition, condition_of
from day6_core.lessons.document import HINTS, Action, Answer, Lesson, Page, Step, Wrong
from day6_core.lessons.flaws import MarkedMap, line_of, meant
from day6_core.lessons.remarks import note_remarks
from day6_core.lessons.source import NAME, LessonSource
from day6_core.width import text_width

PARTS = ("do", "hints", "answers", "teacher")
PICTURE_LINES, PICTURE_COLUMNS = 9, 34

SEEN = ("terminal", *WINDOWS)
"""What `see` may name."""

_HEAD = ("lesson", "drill", "order", "minutes", "title", "fault", "topic")
_STEP = ("check", "solve", "wrong", "needs", "before", "command", "see")
_WRONG = ("do", "says", "undo")
_HINT = re.compile(r"\d+\.(?:\s+(.*))?\Z")
_ANSWER = re.compile(r"-\s+([a-z]):\s+(.*?)(?:\s*\|\s*(.*))?\Z")


def read_lesson(path: Path) -> Lesson:
    """Read a lesson. Raises LessonMistakes, or OSError where there is no such file."""
    return _Reader(LessonSource(path)).lesson()


@dataclass
class _Text:
    """A step's text in one language as it is read, and the lines in which its parts ('' for the whole) begin."""

    page: Page
    lines: dict[str, int]


class _Reader:
    def __init__(self, source: LessonSource) -> None:
        self._source = source
        self._wrong = source.wrong

    def lesson(self) -> Lesson:
        head, begin = self._source.front_matter("lesson")
        steps = [self._step(*each) for each in self._sections(begin)]
        self._source.judge_parts(steps, "step")
        lesson = self._lesson_of(head, steps)
        note_remarks(self._source, head, lesson)
        self._source.judge()
        return replace(lesson, remarks=tuple(sorted(self._source.remarks, key=lambda each: each.line)))

    def _lesson_of(self, head: MarkedMap, steps: list[Step]) -> Lesson:
        unknown = self._source.judge_keys(head, _HEAD, 1)
        drill = "drill" in head
        key = "drill" if drill else "lesson"
        name = head.get(key)
        if key in head and (not isinstance(name, str) or not NAME.match(name)):
            self._wrong(line_of(head, key), f"'{key}' has to be a name of letters a-z, digits, '_' and '-'")
        elif key not in head and not unknown and not head.broken:
            self._wrong(1, "'lesson: NAME' (or 'drill: NAME') is missing")
        numbers = {}
        for key, least in (("order", 0), ("minutes", 1), ("fault", 0)):
            value = head.get(key, least)
            if not isinstance(value, int) or isinstance(value, bool) or value < least:
                self._wrong(line_of(head, key) or 1, f"'{key}' has to be a whole number from {least} on")
                value = least
            numbers[key] = value
        if drill and len(steps) > 1:
            self._wrong(steps[1].line, f"a drill has one step, not {len(steps)}")
        title = self._source.title(head)
        return Lesson(
            str(name), self._source.path, numbers["order"], numbers["minutes"], title, tuple(steps), drill,
            numbers["fault"], str(head.get("topic", "")), line_of(head, "drill" if drill else "lesson"),
        )  # fmt: skip

    def _sections(self, begin: int) -> list[tuple[str, int, list[Block]]]:
        """The steps: name, number of the line with the name, blocks below."""
        found: list[tuple[str, int, list[Block]]] = []
        told = False
        for block in blocks(self._source.lines[begin:], begin + 1):
            if block.open:
                where, end = block.line - 1, block.closed_before()
                self._wrong(where, f"this block is not closed: '~~~' (as it began) is missing before line {end}")
            if block.kind == "#":
                found.append((block.text, block.line, []))
            elif found:
                found[-1][2].append(block)
            elif not told:
                self._wrong(block.line, "text before the first step: one begins with '# NAME'")
                told = True
        return found

    # -- one step ------------------------------------------------------------------------------------------------------

    def _step(self, name: str, line: int, below: list[Block]) -> Step:
        if not NAME.match(name):
            self._wrong(line, f"'{name}': the name of a step is of letters a-z, digits, '_' and '-'")
        data = MarkedMap()
        data.line = line
        texts: dict[str, _Text] = {}
        here: _Text | None = None
        part = ""
        for block in below:
            if block.kind == "yaml" and here is None:
                if data.lines or data.broken:
                    self._wrong(block.line, "a step has one yaml block: put this into the first")
                else:
                    data = self._source.yaml(block.text, block.line)
            elif block.kind == "##":
                language, _, title = block.text.partition(" ")
                part = ""
                if language not in LANGUAGES or language in texts:
                    self._wrong(
                        block.line, f"expected '## zh TITLE' or '## en TITLE', once each, not '## {block.text}'"
                    )
                if not title.strip():
                    self._wrong(block.line, f"'## {language}' has no title")
                here = texts[language] = _Text(Page(title.strip()), {"": block.line})
            elif here is None:
                self._wrong(block.line, "only a yaml block may stand before '## zh'")
            elif block.kind == "###":
                part = block.text.strip()
                if part not in PARTS:
                    self._wrong(block.line, f"unknown part '### {part}'{meant(part, PARTS)}")
                here.lines.setdefault(part, block.line)
            else:
                here.page = self._with_block(here.page, part, block)
        step = self._step_of(name, line, data, {language: each.page for language, each in texts.items()})
        self._judge_pages(step, texts)
        return step

    def _with_block(self, page: Page, part: str, block: Block) -> Page:
        if block.kind == "picture" and not part:
            rows = tuple(block.text.split("\n")) if block.text else ()
            widest = max(map(text_width, rows), default=0)
            if len(rows) > PICTURE_LINES or widest > PICTURE_COLUMNS + self._source.stretched:
                self._wrong(
                    block.line,
                    f"the picture has {widest} columns, {len(rows)} lines; the most are {PICTURE_COLUMNS} and {PICTURE_LINES}",
                )
            return replace(page, picture=rows)
        self._note_width(block)
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

    def _note_width(self, block: Block) -> None:
        """Tell of code that is wider than the window; a drill's symptom is what it is."""
        if not block.kind or any(line.startswith("drill:") for line in self._source.lines[:20]):
            return
        for number, row in enumerate(block.text.split("\n"), block.line):
            if text_width(row) > PICTURE_COLUMNS:
                told = (
                    f"{text_width(row)} columns of code: the window has {PICTURE_COLUMNS} at 80x24, the line is broken"
                )
                self._source.remark(number, told, warning=True)
                return

    def _hints(self, block: Block) -> list[str]:
        found: list[str] = []
        for number, line in enumerate(block.text.split("\n"), block.line):
            match = _HINT.match(line.strip())
            if match is not None:
                if not match[1]:
                    self._wrong(number, "this hint has no text")
                found.append(match[1] or "-")
            elif line.strip() and found:
                found[-1] += " " + line.strip()
            elif line.strip():
                self._wrong(number, "a hint begins with its number, a dot and a blank: '1. …'")
                found.append("-")
        return found

    def _answers(self, block: Block) -> list[Answer]:
        found = []
        for number, line in enumerate(block.text.split("\n"), block.line):
            match = _ANSWER.match(line.strip())
            if match is not None:
                found.append(Answer(match[1], match[2], match[3] or ""))
            elif line.strip():
                self._wrong(number, "an answer is '- a: TEXT | REASON'")
        return found

    def _step_of(self, name: str, line: int, data: MarkedMap, pages: dict[str, Page]) -> Step:
        unknown = self._source.judge_keys(data, _STEP, line)
        given = self._source.list(data, "check", line)
        if not data.get("check") and not unknown and not data.broken:
            self._wrong(line, f"step '{name}' checks nothing")
        checks = []
        for at, each in enumerate(given):
            made = condition_of(each)
            if isinstance(made, Condition):
                checks.append(made)
                self._judge_files(made, "check")
            else:
                self._source.flaw(line_of(given, at) or line, "check", made)
        wrong = self._wrong_answers(data, line)
        needs = self._source.list(data, "needs", line)
        solve = self._actions(data, "solve", line)
        typed = next((str(each["type"]).strip().split("\n")[0] for each in solve if "type" in each), "")
        return Step(
            name,
            line,
            tuple(checks),
            solve,
            wrong,
            tuple(map(str, needs)),
            self._actions(data, "before", line),
            str(data.get("command", typed)).rstrip("\n"),
            self._seen(data, line),
            pages,
            dict(data.lines),
            data.broken,
        )

    def _seen(self, data: MarkedMap, line: int) -> tuple[str, ...]:
        """What the step has on the screen."""
        given = self._source.list(data, "see", line)
        for at, each in enumerate(given):
            if each not in SEEN:
                self._wrong(line_of(given, at) or line, f"see: there is no window '{each}'{meant(str(each), SEEN)}")
        return tuple(map(str, given)) or ("terminal",)

    def _wrong_answers(self, data: MarkedMap, line: int) -> tuple[Wrong, ...]:
        found = []
        given = self._source.list(data, "wrong", line)
        for number, each in enumerate(given):
            at = line_of(given, number) or line
            if not isinstance(each, dict) or not isinstance(each.get("says"), str) or each.keys() - set(_WRONG):
                told = "wrong: each needs 'do' (actions) and 'says' (a text), and may have 'undo'"
                strange = next((key for key in each if key not in _WRONG), None) if isinstance(each, dict) else None
                if strange is not None:
                    at, told = line_of(each, strange) or at, f"{told}; '{strange}' is unknown{meant(strange, _WRONG)}"
                self._wrong(at, told)
                continue
            wrong = Wrong(self._actions(each, "do", at), each["says"], self._actions(each, "undo", at), at)
            if not each.get("do"):
                self._wrong(at, "wrong: 'do' (the actions of the wrong answer) is missing")
            found.append(wrong)
        return tuple(found)

    def _actions(self, data: dict[str, Any], key: str, line: int) -> tuple[Action, ...]:
        found = []
        given = self._source.list(data, key, line)
        for at, each in enumerate(given):
            mistake = action_mistake(each)
            if mistake:
                self._source.flaw(line_of(given, at) or line, key, mistake)
            else:
                found.append(each)
                if "wait" in each and isinstance(made := condition_of(each["wait"]), Condition):
                    self._judge_files(made, f"{key}: wait")
        return tuple(found)

    def _judge_files(self, condition: Condition, where: str) -> None:
        """The Python files of a check have to lie beside the lesson."""
        folder = self._source.path.parent.resolve()
        for each in condition.every():
            if each.name == "python":
                name = each.arguments["file"]
                path = (folder / name).resolve()
                if folder not in path.parents:
                    self._wrong(each.line, f"{where}: python: '{name}' has to lie in the folder of the lesson")
                elif not path.is_file():
                    self._wrong(each.line, f"{where}: python: there is no file '{name}' beside the lesson")

    def _judge_pages(self, step: Step, texts: dict[str, _Text]) -> None:
        asked = next((check for check in _all(step.checks) if check.name == "answer"), None)
        for language in LANGUAGES:
            if language not in texts:
                if texts.keys() - set(LANGUAGES):
                    continue  # told where it stands
                self._wrong(step.line, f"step '{step.name}' has no '## {language}' part")
                continue
            page, lines = texts[language].page, texts[language].lines
            where = f"step '{step.name}', {language}"
            if not page.body.strip():
                self._wrong(lines[""], f"{where}: there is no text")
            if not page.do.strip() and not any(part not in (*PARTS, "") for part in lines):
                self._wrong(lines.get("do", lines[""]), f"{where}: '### do' is missing or empty")
            if len(page.hints) != HINTS and ("hints" in lines or not any(part not in (*PARTS, "") for part in lines)):
                told = f"{where}: {HINTS} hints are needed, there are {len(page.hints)}"
                self._wrong(lines.get("hints", lines[""]), told)
            letters = [answer.letter for answer in page.answers]
            if asked is not None and asked.arguments["letter"] not in letters:
                told = f"{where}: '### answers' has no '{asked.arguments['letter']}'"
                self._wrong(lines.get("answers", lines[""]), told)
            for letter in sorted({each for each in letters if letters.count(each) > 1}):
                self._wrong(lines["answers"], f"{where}: two answers are called '{letter}'")


def _all(checks: Iterable[Condition]) -> list[Condition]:
    return [part for check in checks for part in check.every()]


def _joined(before: str, text: str) -> str:
    return f"{before}\n\n{text.strip(chr(10))}" if before else text.strip("\n")
