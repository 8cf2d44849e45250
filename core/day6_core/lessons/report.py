"""`day6-tui report`: how far all pupils of this machine or of a class are; on the terminal, as CSV, as a page."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

from day6_core.classroom.homes import is_class
from day6_core.language import language_of
from day6_core.lessons import parsers
from day6_core.lessons.catalogue import offer
from day6_core.lessons.class_table import Table, Unread, class_of, table_of
from day6_core.lessons.progress import FOLDER, Progress, ProgressError, load
from day6_core.lessons.report_lines import ReportLine, cells, heads, lines_of, moment
from day6_core.lessons.tables import (
    Exists,
    csv_bytes,
    html_page,
    html_table,
    html_text,
    must_be_new,
    text_table,
    write_table,
)
from day6_core.lessons.texts import Say
from day6_core.places import default_home
from day6_core.reason import reason
from day6_core.session.harmless import one_line


def _table_of_lines(found: list[ReportLine], language: str) -> Table:
    short = [cells(line, language, short=True) for line in found]
    return Table(heads(language), [cells(line, language) for line in found], heads(language), short)


def page(table: Table, language: str, folder: Path, now: float) -> bytes:
    """The HTML page."""
    title = Say("report.title").text(language)
    made = Say("report.made", when=moment(now), folder=str(folder)).text(language)
    honest = Say("report.honest").text(language)
    parts = [html_text(title, "h1"), html_table(table.heads, table.rows), html_text(made), html_text(honest)]
    return html_page(title, language, parts)


def _pupils(folder: Path) -> tuple[list[Progress], list[Unread]]:
    """The pupils by name, and the files that cannot be used."""
    found: list[Progress] = []
    broken: list[Unread] = []
    for path in sorted(folder.glob("*.json")):
        try:
            progress = load(path)
        except ProgressError as error:
            broken.append(Unread(path, str(error)))
        except OSError as error:
            broken.append(Unread(path, reason(error)))
        else:
            progress.pupil = progress.pupil or path.stem
            found.append(progress)
    return found, broken


def main(arguments: list[str]) -> int:
    """Run `day6-tui report ARGUMENTS`; returns the exit status."""
    language = language_of(os.environ, arguments)
    options = parsers.report(language).parse_args(arguments)

    def tell(key: str, **values: object) -> int:
        print(one_line(f"day6-tui report: {Say(key, **values).text(language)}"), file=sys.stderr)
        return 1

    offered = offer(options.lessons)
    home = (options.home or default_home()).expanduser().resolve()
    folder = home / FOLDER if options.data is None else options.data
    try:
        if options.data is None:
            known, broken = _pupils(folder)
            table = _table_of_lines(lines_of(known, offered.lessons, offered.drills), language)
        elif sys.platform == "win32":
            return tell("report.windows")
        elif not is_class(folder):
            return tell("report.class_none", folder=folder)
        else:
            pupils = class_of(folder)
            broken = [bad for pupil in pupils for bad in pupil.unread]
            table = table_of(pupils, offered, language)
            if any(pupil.is_closed for pupil in pupils):
                tell("report.closed")
    except PermissionError:
        return tell("report.closed")
    except OSError as error:
        return tell("office.failed", file=error.filename or folder, reason=reason(error))
    for bad in broken:
        tell("report.broken", file=bad.file, reason=bad.text(language))
    if not table.rows:
        return tell("report.class_here", folder=home) if is_class(home) else tell("report.none", folder=folder)
    try:
        must_be_new([options.csv, options.html], options.force)
        if options.csv is not None:
            write_table(options.csv, csv_bytes(table.heads, table.rows), options.force)
        if options.html is not None:
            write_table(options.html, page(table, language, folder, time.time()), options.force)
    except Exists as error:
        return tell("office.exists", file=error)
    except OSError as error:
        return tell("office.failed", file=error.filename or "", reason=reason(error))
    for path in (options.csv, options.html):
        if path is not None:
            print(one_line(Say("office.written", file=path).text(language)))
    if options.csv is None and options.html is None:
        print(text_table(table.short_heads, table.short))
        print(f"\n{Say('report.honest').text(language)}")
    return 1 if broken else 0
