"""The parsers of `day6-tui lessons`, `submit`, `grade` and `report`; without what these commands themselves need."""

from __future__ import annotations

from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.values import Values
from day6_core.lessons.grading.limits import LONGEST, MOST_JOBS


def lessons(language: str = "en") -> CommandParser:
    """`day6-tui lessons VERB …`."""
    parser = command_parser("lessons", language)
    texts = parser.texts
    parser.epilog = texts("cli.lessons.more")
    parser.add_verb("list")
    parser.add_verb("help")
    new = parser.add_verb("new")
    new.add_argument("file", type=Path, metavar="FILE.md", help=texts("cli.lessons.new.file"))
    new.add_argument("--drill", action="store_true", help=texts("cli.lessons.new.drill"))
    for verb in ("check", "preview", "play"):
        added = parser.add_verb(verb)
        added.add_argument("file", type=Path, nargs="+", metavar="FILE", help=texts("cli.lessons.file"))
    added.add_argument("--step", metavar="NAME", help=texts("cli.lessons.step"))
    added.add_argument("--real-time", action="store_true", help=texts("cli.real_time"))
    return parser


def submit(language: str = "en") -> CommandParser:
    """`day6-tui submit …`."""
    parser = command_parser("submit", language)
    texts, values = parser.texts, Values(parser.texts)
    parser.add_argument("--home", type=values.home, metavar="DIR", help=texts("cli.options.home"))
    parser.add_argument("--lesson", default="", metavar="NAME", help=texts("cli.submit.lesson"))
    parser.add_argument("--pupil", default="", metavar="NAME", help=texts("cli.submit.pupil"))
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help=texts("cli.submit.output"))
    return parser


def grade(language: str = "en") -> CommandParser:
    """`day6-tui grade FILE … …`."""
    parser = command_parser("grade", language)
    texts, values = parser.texts, Values(parser.texts)
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE", help=texts("cli.grade.files"))
    parser.add_argument("--data", type=values.folder, metavar="DIR", help=texts("cli.grade.data"))
    parser.add_argument("--lesson", default="", metavar="NAME", help=texts("cli.grade.lesson"))
    parser.add_argument("--scenarios", type=Path, metavar="DIR", help=texts("cli.grade.scenarios"))
    _add_tables(parser)
    parser.add_argument("--jobs", type=values.whole(1, MOST_JOBS), metavar="N", help=texts("cli.grade.jobs"))
    parser.add_argument("--json", type=Path, metavar="FILE", help=texts("cli.grade.json"))
    parser.add_argument(
        "--seconds", type=values.number(1, LONGEST), metavar="S", help=texts("cli.grade.seconds")
    )  # fmt: skip
    parser.add_argument("--seed", default="", metavar="WORD", help=texts("cli.grade.seed"))
    return parser


def report(language: str = "en") -> CommandParser:
    """`day6-tui report …`."""
    parser = command_parser("report", language)
    texts, values = parser.texts, Values(parser.texts)
    whose = parser.add_mutually_exclusive_group()
    whose.add_argument("--home", type=values.home, metavar="DIR", help=texts("cli.options.home"))
    whose.add_argument("--data", type=values.folder, metavar="DIR", help=texts("cli.report.data"))
    parser.add_argument("--lessons", type=values.folder, metavar="DIR", help=texts("cli.report.lessons"))
    _add_tables(parser)
    return parser


def _add_tables(parser: CommandParser) -> None:
    texts = parser.texts
    parser.add_argument("--csv", type=Path, metavar="FILE", help=texts("cli.options.csv"))
    parser.add_argument("--html", type=Path, metavar="FILE", help=texts("cli.options.html"))
    parser.add_argument("--force", action="store_true", help=texts("cli.options.force"))
