"""`day6-tui bag-csv BAG [TOPIC…]`: the messages of a bag as tables for a spreadsheet, one file for each topic."""

from __future__ import annotations

import os
import shlex
import sys
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import language_of
from day6_core.reason import reason
from day6_core.session.harmless import one_line

if TYPE_CHECKING:
    from argparse import Namespace

    from rosbag2_py._csv import CsvExport

    from day6_core.command_line.texts import Wording


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui bag-csv`, and what it takes."""
    parser = command_parser("bag-csv", language)
    texts, add = parser.texts, parser.add_argument
    add("bag", metavar="BAG", type=Path, help=texts("cli.bag-csv.bag"))
    add("topics", metavar="TOPIC", nargs="*", help=texts("cli.bag-csv.topics"))
    add("-o", "--output", metavar="DIR", type=Path, help=texts("cli.bag-csv.output"))
    add("-f", "--force", action="store_true", help=texts("cli.bag-csv.force"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui bag-csv WORD…`; returns the exit status."""
    from day6_core.ros.environment import activate

    activate()
    parser = build_parser(language_of(os.environ, words))
    options = parser.parse_args(words)
    command = _Command(parser, options)
    try:
        return command.run()
    except OSError as error:
        if error.filename is None:
            raise  # of standard output
        return command.tell(f"{error.filename!r}: {reason(error)}")


class _Command:
    """One run: what it says goes to standard error, the files' names to standard output."""

    def __init__(self, parser: CommandParser, options: Namespace) -> None:
        self._prog = parser.prog
        self._texts: Wording = parser.texts
        self._bag: Path = options.bag
        self._wanted: list[str] = options.topics
        self._force: bool = options.force
        self._folder: Path = options.output or Path(f"{self._bag.resolve().stem}_csv")
        self._said: list[str] = []

    def tell(self, text: str) -> int:
        """Say something on standard error; return the status of a failure."""
        print(f"{self._prog}: {one_line(text)}", file=sys.stderr)
        return 1

    def _tell(self, key: str, **values: object) -> int:
        return self.tell(self._texts(f"cli.bag-csv.{key}", **values))

    def run(self) -> int:
        """Read and write; return the exit status."""
        from rosbag2_py._csv import CsvExport

        try:
            export = CsvExport(str(self._bag), lambda level, logger, text: self._said.append(text))
        except (RuntimeError, OSError) as error:
            return self._unreadable(error)
        try:
            return self._export(export)
        finally:
            export.close()

    def _unreadable(self, error: Exception) -> int:
        if not self._bag.exists():
            return self._tell("missing", bag=self._bag)
        self._tell("unreadable", bag=self._bag, reason=reason(error))
        if self._bag.is_dir() and not (self._bag / "metadata.yaml").exists():
            self._tell("reindex", command=f"ros2 bag reindex {shlex.quote(str(self._bag))}")
        return 1

    def _export(self, export: CsvExport) -> int:
        from rosbag2_py._csv import file_names

        topics = [f"/{name.strip('/')}" for name in self._wanted] or sorted(export.topics)
        for topic in topics:
            if topic not in export.topics:
                return self._tell("no_topic", topic=topic, bag=self._bag, topics=", ".join(sorted(export.topics)))
        files = {topic: self._folder / name for topic, name in file_names(sorted(export.topics)).items()}
        refused = [self._refusal(files[topic]) for topic in topics]
        if any(refused):
            return 1
        tables, unknown = export.tables(dict.fromkeys(topics))
        for topic, kind in unknown.items():
            self._tell("unknown_type", topic=topic, type=kind)
        if not tables:
            return 1 if unknown else self._tell("empty", bag=self._bag)
        self._folder.mkdir(parents=True, exist_ok=True)
        try:
            export.write(tables, files)
        finally:
            with suppress(OSError):
                self._folder.rmdir()  # nothing was written into it
        for topic, table in tables.items():
            print(
                self._texts(
                    "cli.bag-csv.done", file=files[topic], topic=topic, rows=table.rows, columns=len(table.head())
                )
            )
            if cut := table.cut():
                self._tell("cut", topic=topic, names=", ".join(cut), most=max(cut.values()))
            if table.unreadable:
                self._tell("left_out", topic=topic, count=table.unreadable)
        if export.damage:
            self._tell("damaged", bag=self._bag, reason=export.damage)
        return int(bool(unknown or export.damage or any(table.unreadable for table in tables.values())))

    def _refusal(self, file: Path) -> int:
        from rosbag2_py._csv import is_ours

        if not os.path.lexists(file):
            return 0
        return (
            self._tell("foreign", file=file)
            if not is_ours(file)
            else 0
            if self._force
            else self._tell("exists", file=file)
        )
