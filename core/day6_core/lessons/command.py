"""`day6-tui lessons`: lists, checks, shows, plays and begins lesson files."""

from __future__ import annotations

import argparse
import os
import re
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path

from day6_core.language import language_of
from day6_core.lessons import parsers
from day6_core.lessons.catalogue import HERE, lessons_in, offer, shipped_names
from day6_core.lessons.document import Lesson
from day6_core.lessons.flaws import meant
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.source import LessonMistakes, Mistake
from day6_core.session.harmless import lines, one_line
from day6_core.virtual.surroundings import begin_anew, is_due

WRITING = Path(__file__).with_name("writing")
"""How lessons are written, a page in each language; the documentation has a copy of them."""
EXAMPLES = {"lesson": "example.md", "drill": "example_drill.md"}


def main(words: list[str]) -> int:
    """Entry point; returns the exit status."""
    language = language_of(os.environ, words)
    options = parsers.lessons(language).parse_args(words)
    options.lang = language
    try:
        if options.verb == "list":
            return _list()
        if options.verb == "help":
            print((WRITING / f"{language}.md").read_text(encoding="utf-8"), end="")
            return 0
        if options.verb == "new":
            return _new(options.file, "drill" if options.drill else "lesson")
        if options.verb == "play" and is_due(real_time=options.real_time):
            begin_anew(sys.orig_argv, os.environ)
        results = [_with(options, file) for file in options.file]
    except OSError as error:
        if error.filename is None:  # not of a file: of what is printed
            raise
        print(one_line(f"day6-tui lessons: {error.filename}: {error.strerror}"), file=sys.stderr)
        return 2
    return max(results)


def _list() -> int:
    found = offer()
    for lesson in found.all:
        kind = f"drill {found.drills.index(lesson) + 1:2}" if lesson.is_drill else "lesson  "
        print(f"{kind}  {lesson.name:24} {lesson.minutes:3} min  {lesson.title['zh']} / {lesson.title['en']}")
    return 0


def _new(path: Path, kind: str) -> int:
    example = Path(__file__).with_name(EXAMPLES[kind]).read_text(encoding="utf-8")
    if path.suffix != ".md":
        told = f"day6-tui lessons: {path}: the name of a lesson's file ends in .md; --lessons would not see this one"
        print(one_line(told), file=sys.stderr)
        return 2
    name = (
        "".join(char if char.isascii() and char.isalnum() else "_" for char in path.stem.lower()).strip("_") or "lesson"
    )
    try:
        with open(path, "x", encoding="utf-8", newline="\n") as file:
            file.write(re.sub(rf"^{kind}: \w+$", f"{kind}: {name}", example, count=1, flags=re.MULTILINE))
    except FileExistsError:
        print(one_line(f"day6-tui lessons: {path} is there already; it is not overwritten"), file=sys.stderr)
        return 1
    print(one_line(f"{path} is written. Next: day6-tui lessons play {path}"))
    return 0


def _with(options: argparse.Namespace, file: Path) -> int:
    """Do the verb with one file, or with all of a folder."""
    if not file.is_dir():
        try:
            return _one(options, read_lesson(file), [])
        except LessonMistakes as mistakes:
            _print_mistakes(file, mistakes.mistakes)
            return 1
    found = lessons_in(file)
    for broken in found.broken:
        _print_mistakes(file / broken.path.name, broken.mistakes)
    status = max((_one(options, lesson, found.all) for lesson in found.all), default=0)
    if not found.all and not found.broken:
        print(one_line(f"day6-tui lessons: {file}: there is no lesson (*.md) in this folder"), file=sys.stderr)
        return 1
    return 1 if found.broken else status


def _print_mistakes(path: Path, mistakes: Iterable[Mistake]) -> None:
    for each in mistakes:
        told = f"warning: {each.text}" if each.warning else each.text
        print(one_line(f"{path}:{each.line}: {told}"), file=sys.stderr)


def _one(options: argparse.Namespace, lesson: Lesson, others: Iterable[Lesson]) -> int:
    if options.verb == "check":
        remarks = [*_same_name(lesson, others), *lesson.remarks]
        _print_mistakes(lesson.path, remarks)
        wrong = sum(not each.warning for each in remarks)
        told = f"{len(lesson.steps)} step{'' if len(lesson.steps) == 1 else 's'}"
        counts = ((wrong, "mistake"), (len(remarks) - wrong, "warning"))
        said = ", ".join(f"{count} {word}{'' if count == 1 else 's'}" for count, word in counts if count)
        print(one_line(f"{lesson.path}: {told}, {said if wrong else ', '.join(filter(None, ('no mistake', said)))}"))
        return 1 if wrong else 0
    if options.verb == "preview":
        _preview(lesson, options.lang)
        return 0
    return _play(lesson, options.step)


def _same_name(lesson: Lesson, others: Iterable[Lesson]) -> list[Mistake]:
    """Progress is kept under the name: two lessons of one name would share it."""
    line = lesson.line
    if HERE not in lesson.path.resolve().parents and lesson.name in shipped_names():
        return [Mistake(line, f"a lesson that comes with day6-tui is called '{lesson.name}' too: take another name")]
    twin = next((each for each in others if each is not lesson and each.name == lesson.name), None)
    return [Mistake(line, f"{twin.path.name} is called '{lesson.name}' too: take another name")] if twin else []


def _preview(lesson: Lesson, language: str) -> None:
    print(lines(f"{lesson.title[language]}  ({lesson.minutes} min)"))
    for number, step in enumerate(lesson.steps, 1):
        page = step.pages[language]
        print(lines(f"\n{number}. {page.title}"))
        for row in page.picture:
            print(lines(f"    {row}"))
        print(lines(f"\n{page.body}\n\n> {page.do}\n"))
        for answer in page.answers:
            print(lines(f"   {answer.letter}) {answer.text}" + (f"  [{answer.reason}]" if answer.reason else "")))
        for count, hint in enumerate(page.hints, 1):
            print(lines(f"   hint {count}: {hint}"))
        if page.teacher:
            print(lines(f"   for the teacher: {page.teacher}"))


def _play(lesson: Lesson, only: str | None) -> int:
    from day6_core.lessons.rehearsal import Played, rehearse

    def tell(played: Played) -> None:
        good = "ok  " if not played.faults else "FAIL"
        print(one_line(f"{good} {played.seconds:5.1f} s  {lesson.path.name}:{played.line}: {played.step}"), flush=True)
        for fault in played.faults:
            print(one_line(f"       {fault}"), flush=True)

    if only is not None and lesson.step(only) is None:
        told = f"{lesson.path}: there is no step '{only}'{meant(only, [step.name for step in lesson.steps])}"
        print(one_line(told), file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory(prefix="day6-lesson-", ignore_cleanup_errors=True) as folder:
        try:
            found = rehearse(lesson, Path(folder) / "home", tell, only)
        except TimeoutError as error:
            print(one_line(f"FAIL {lesson.path.name}: {error}"))
            return 1
    return 1 if any(each.faults for each in found) else 0
