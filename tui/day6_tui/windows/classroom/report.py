"""What is kept of a lesson: how far each pupil came, and beside it what happened, as two tables for a spreadsheet."""

from __future__ import annotations

from pathlib import Path

from day6_core.classroom.roster import Reached, Roster
from day6_core.lessons.tables import csv_bytes, must_be_new, write_table
from day6_tui.classes.log import as_csv
from day6_tui.locale import Texts


def log_beside(report: Path) -> Path:
    """The file of the log beside a report's."""
    return report.with_name(f"{report.stem}-log.csv")


def write_report(path: Path, roster: Roster, texts: Texts) -> list[str]:
    """Write both files and return their names. Raises Exists before anything is written, OSError."""
    log = log_beside(path)
    must_be_new([path, log], force=False)
    heads = [texts(f"teacher.csv.{name}") for name in Reached._fields]
    rows = [[each or "" for each in reached] for reached in roster.report()]
    write_table(path, csv_bytes(heads, rows), force=False)
    write_table(log, as_csv(roster.journal.events(), texts), force=False)
    return [path.name, log.name]
