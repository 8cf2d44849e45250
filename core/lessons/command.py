"""`day6-tui lessons`: lists, checks, shows, plays and begins lesson files."""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from day6_tui.core.lessons.catalogue import days, drills, lessons_in
from day6_tui.core.lessons.document import LANGUAGES, Lesson, LessonMistakes, read_lesson
from day6_tui.core.session.harmless import lines, one_line

WRITING = Path(__file__).with_name("WRITING.md")


def main(words: list[str]) -> int:
    """Entry point; returns the exit status."""
    parser = argparse.ArgumentParser(prog="day6-tui lessons", description="Lesson files: see 'day6-tui lessons help'.")
    verbs = parser.add_subparsers(dest="verb", metavar="VERB")
    verbs.add_parser("list", help="the lessons and drills there are")
    verbs.add_parser("help", help="how lessons are written")
    add = verbs.add_parser("new", help="write a small lesson that works")
    add.add_argument("file", type=Path)
    for verb, text in (
        ("check", "name every mistake with its line"),
        ("preview", "show how it looks"),
        ("play", "play the solutions and the wrong answers on a machine of its own"),
    ):
        sub = verbs.add_parser(verb, help=text)
        sub.add_argument("file", type=Path, nargs="+")
        if verb == "preview":
            sub.add_argument("--lang", choices=LANGUAGES, default="zh")
    options = parser.parse_args(words)
    if options.verb is None:
        parser.print_help()
        return 2
    try:
        if options.verb == "list":
            return _list()
        if options.verb == "help":
            print(WRITING.read_text(encoding="utf-8"), end="")
            return 0
        if options.verb == "new":
            return _new(options.file)
        results = [_with(options, file) for file in options.file]
    except OSError as error:
        print(one_line(f"day6-tui lessons: {error.filename}: {error.strerror}"), file=sys.stderr)
        return 2
    return max(results)


def _list() -> int:
    for lesson in (*days(), *drills()):
        kind = f"drill {lesson.fault:2}" if lesson.is_drill else "lesson  "
        print(f"{kind}  {lesson.name:24} {lesson.minutes:3} min  {lesson.title['zh']} / {lesson.title['en']}")
    return 0


def _new(path: Path) -> int:
    example = Path(__file__).with_name("example.md").read_text(encoding="utf-8")
    name = (
        "".join(char if char.isascii() and char.isalnum() else "_" for char in path.stem.lower()).strip("_") or "lesson"
    )
    try:
        with open(path, "x", encoding="utf-8", newline="\n") as file:
            file.write(example.replace("lesson: example", f"lesson: {name}"))
    except FileExistsError:
        print(one_line(f"day6-tui lessons: {path} is there already; it is not overwritten"), file=sys.stderr)
        return 1
    print(one_line(f"{path} is written. Next: day6-tui lessons play {path}"))
    return 0


def _with(options: argparse.Namespace, file: Path) -> int:
    """Do the verb with one file."""
    found = lessons_in(file) if file.is_dir() else None
    if found is not None:
        for mistakes in found.mistakes:
            print(lines(str(mistakes)), file=sys.stderr)
        status = max((_one(options, lesson) for lesson in found.lessons), default=0)
        return 1 if found.mistakes else status
    try:
        lesson = read_lesson(file)
    except LessonMistakes as mistakes:
        print(lines(str(mistakes)), file=sys.stderr)
        return 1
    return _one(options, lesson)


def _one(options: argparse.Namespace, lesson: Lesson) -> int:
    if options.verb == "check":
        print(one_line(f"{lesson.path}: {len(lesson.steps)} steps, no mistake"))
        return 0
    if options.verb == "preview":
        _preview(lesson, options.lang)
        return 0
    return _play(lesson)


def _preview(lesson: Lesson, language: str) -> None:
    print(lines(f"{lesson.title[language]}  ({lesson.minutes} min)"))
    for number, step in enumerate(lesson.steps, 1):
        page = step.pages[language]
        print(lines(f"\n{number}. {page.title}"))
        for row in page.picture:
            print(lines(f"    {row}"))
        print(lines(f"\n{page.body}\n\n> {page.do}\n"))
        for answer in page.answers:
            print(lines(f"   {answer.letter}) {answer.text}"))
        for count, hint in enumerate(page.hints, 1):
            print(lines(f"   hint {count}: {hint}"))


def _play(lesson: Lesson) -> int:
    from day6_tui.core.lessons.rehearsal import Played, rehearse

    def tell(played: Played) -> None:
        good = "ok  " if not played.faults else "FAIL"
        print(one_line(f"{good} {played.seconds:5.1f} s  {lesson.path.name}:{played.line}: {played.step}"), flush=True)
        for fault in played.faults:
            print(one_line(f"       {fault}"), flush=True)

    with tempfile.TemporaryDirectory(prefix="day6-lesson-", ignore_cleanup_errors=True) as folder:
        try:
            found = rehearse(lesson, Path(folder) / "home", tell)
        except TimeoutError as error:
            print(one_line(f"FAIL {lesson.path.name}: {error}"))
            return 1
    return 1 if any(each.faults for each in found) else 0
