"""`day6-tui grade`: runs the programs of submissions on hidden scenarios and writes what was seen."""

from __future__ import annotations

import os
import signal
import sys
import tempfile
import threading
import time
from argparse import Namespace
from collections.abc import Callable
from functools import partial
from pathlib import Path

from day6_core.classroom.homes import folder_name, hidden_of, homes_of, is_class
from day6_core.command_line.texts import Wording
from day6_core.language import language_of
from day6_core.lessons import parsers
from day6_core.lessons.grading import remarks, reports
from day6_core.lessons.grading.grader import Grader
from day6_core.lessons.grading.grades import Graded
from day6_core.lessons.grading.limits import MOST_JOBS
from day6_core.lessons.grading.scenarios import HERE, Grading, gradings
from day6_core.lessons.lag import cores
from day6_core.lessons.source import LessonMistakes
from day6_core.lessons.tables import Exists, must_be_new, write_table
from day6_core.lessons.texts import Say
from day6_core.reason import reason
from day6_core.session.harmless import lines, one_line
from day6_core.virtual.surroundings import is_there

Tell = Callable[..., int]
"""Says a text by its key and what fills it; returns the exit status."""

JOBS_FOR_A_CORE = 1 if is_there() else 10
"""In real time a submission waits most of its time: for a turtle to arrive, for the next message."""

MEMORY_FOR_A_JOB = 250 * 2**20


def default_jobs() -> int:
    """How many submissions at a time this machine has cores and memory for."""
    if sys.platform == "win32":
        return 1
    try:
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (OSError, ValueError, AttributeError):
        memory = 4 * 2**30
    return max(1, min(cores() * JOBS_FOR_A_CORE, memory // 2 // MEMORY_FOR_A_JOB, MOST_JOBS))


def main(arguments: list[str]) -> int:
    """Run `day6-tui grade ARGUMENTS`; the status is 0 if every submission passed everything, 1 if not, 2 for a bad call."""
    language = language_of(os.environ, arguments)
    parser = parsers.grade(language)
    options = parser.parse_args(arguments)
    if not options.files and options.data is None:
        parser.error(parser.texts("cli.error.one_of", names="FILE --data"))

    def tell(key: str, **values: object) -> int:
        print(one_line(f"day6-tui grade: {Say(key, **values).text(language)}"), file=sys.stderr)
        return 2

    if sys.platform == "win32":
        return tell("grade.windows")
    try:
        chosen = _chosen(options.scenarios, options.lesson)
        must_be_new([options.csv, options.html, options.json], options.force)
        words = remarks.read(options.csv)
    except LessonMistakes as mistakes:
        print(lines(str(mistakes)), file=sys.stderr)
        return 2
    except LookupError as error:
        return tell(*error.args[:1], **error.args[1])
    except Exists as error:
        return tell("office.exists", file=error)
    except remarks.Unreadable as error:
        return tell("grade.remarks_unread", file=error)
    except OSError as error:
        return tell("office.failed", file=error.filename or "", reason=reason(error))
    files = [each for path in options.files for each in (sorted(path.glob("*.zip")) if path.is_dir() else [path])]
    if options.data is None:
        return _grade(options, language, chosen, words, files, tell)
    if not is_class(options.data):
        return tell("report.class_none", folder=options.data)
    with tempfile.TemporaryDirectory(prefix="d6g-") as folder:
        try:
            files += _collected(options.data, Path(folder), options.lesson, partial(_tell_of, parser.texts))
        except PermissionError:
            return tell("report.closed")
        except OSError as error:
            return tell("office.failed", file=error.filename or options.data, reason=reason(error))
        return _grade(options, language, chosen, words, files, tell)


def _collected(data: Path, folder: Path, lesson: str, tell: Callable[[str, object], None]) -> list[Path]:
    """What the pupils of a class have, as submissions in a folder; who has nothing is told. Raises OSError."""
    from day6_core.lessons.collected import collect
    from day6_core.lessons.submission import SubmissionError
    from day6_core.workspace.export import ExportError

    found, closed = [], None
    for home in homes_of(data):
        target = folder / f"{folder_name(home.name)}.zip"
        try:
            packed = collect(home, target, lesson)
        except SubmissionError as error:
            tell(home.name, error.say)
        except ExportError as error:
            tell(home.name, error.reason)
        except FileNotFoundError:
            tell(home.name, Say("grade.never_came"))
        except (PermissionError, NotADirectoryError) as error:  # one pupil's doing: the others are graded
            tell(home.name, reason(error))
            closed = error if isinstance(error, PermissionError) else closed
        else:
            found.append(target)
            for left in packed.left_out:
                tell(home.name, left)
    if closed is not None and not found:
        raise closed
    return found


def _tell_of(texts: Wording, name: str, why: object) -> None:
    """Say what was not collected of a pupil."""
    from day6_core.workspace.export import Reason

    reason = why.said(texts) if isinstance(why, Reason) else why
    print(
        one_line(f"day6-tui grade: {Say('grade.not_collected', name=name, reason=reason).text(texts.language)}"),
        file=sys.stderr,
    )


def _grade(
    options: Namespace, language: str, chosen: list[Grading], words: dict[str, str], files: list[Path], tell: Tell
) -> int:
    """Grade these files and write what was seen; returns the exit status."""
    if not files:
        return tell("grade.nothing", names=tuple(map(str, options.files or [options.data])))
    jobs = min(options.jobs or default_jobs(), len(files))
    hidden = () if options.data is None else hidden_of(options.data)
    grader = Grader(chosen, seconds=options.seconds, seed=options.seed, hidden=hidden)
    began = time.monotonic()
    lock = threading.Lock()

    def told(graded: Graded) -> None:
        with lock:
            print(lines(reports.in_text(reports.data_of([graded], words)["submissions"][0], language)), flush=True)

    def again(count: int) -> None:
        print(
            one_line(f"day6-tui grade: {Say('grade.again', count=count).text(language)}"), file=sys.stderr, flush=True
        )

    before = {number: signal.signal(number, signal.default_int_handler) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        found = grader.grade(files, jobs, told, again)
    except KeyboardInterrupt:
        tell("grade.stopped")
        return 130
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    took = round(time.monotonic() - began, 1)
    total = Say("grade.total", count=len(found), seconds=took, jobs=jobs, seed=grader.seed)
    print(f"\n{one_line(total.text(language))}")
    if any(graded.refused is None and not graded.shielded for graded in found):
        tell("grade.weak")
    if grader.closed is not None:
        tell("grade.root", folder=grader.closed)
    try:
        words |= remarks.read(options.csv)  # they may have been written meanwhile
        about = {"seed": grader.seed, "seconds": took, "jobs": jobs}
        data = reports.data_of(found, words, **about)
        tables = (
            (options.csv, partial(reports.as_csv, data, language, words)),
            (options.html, partial(reports.as_page, data, language, total)),
            (options.json, partial(reports.as_json, data)),
        )
        for path, written in tables:
            if path is not None:
                write_table(path, written(), options.force)
                print(one_line(Say("office.written", file=path).text(language)))
    except Exists as error:
        return tell("office.exists", file=error)
    except remarks.Unreadable as error:
        return tell("grade.remarks_unread", file=error)
    except OSError as error:
        return tell("office.failed", file=error.filename or "", reason=reason(error))
    return 0 if all(graded.refused is None and graded.passed == len(graded.results) for graded in found) else 1


def _chosen(folder: Path | None, lesson: str) -> list[Grading]:
    """The scenarios to play. Raises LessonMistakes, OSError, and LookupError with the key of a text and its values."""
    if folder is not None and not folder.is_dir():
        raise NotADirectoryError(20, os.strerror(20), str(folder))
    found = gradings(folder)
    if not found:
        raise LookupError("grade.no_scenarios", {"folder": str(folder or HERE)})
    chosen = [each for each in found if lesson in ("", each.lesson)]
    if not chosen:
        names = tuple(dict.fromkeys(each.lesson for each in found))
        raise LookupError("grade.no_lesson", {"name": lesson, "names": names})
    return chosen
