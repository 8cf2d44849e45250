"""`day6-tui uninstall`: lists what was written outside of the package, and removes it if wanted."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.guardian import MARK
from day6_core.language import language_of, said
from day6_core.places import PLACES, Place, data_folder, shortened
from day6_core.reason import reason
from day6_core.session.harmless import one_line
from day6_core.width import text_width
from day6_tui.locale import Texts
from day6_tui.upkeep.installation import installation, quoted
from day6_tui.upkeep.removal import Size, remove, size_of
from day6_tui.upkeep.running import Running, running

REFUSED, NOT_REMOVED = 1, 1
BAD_USAGE = 2


class Held(NamedTuple):
    """Something that was found, with its place in the table."""

    place: Place
    path: Path
    size: Size

    @property
    def shown(self) -> str:
        return one_line(shortened(self.path))


def main(words: list[str]) -> int:
    """`day6-tui uninstall [--data [--files]] [--yes]`; returns the exit status."""
    language = language_of(os.environ, words)
    parser, texts = build_parser(language), Texts(language)
    options = parser.parse_args(words)
    if options.files and not options.data:
        parser.error(texts("uninstall.files_alone"))
    if MARK in os.environ:
        print(f"day6-tui: {texts('uninstall.inside')}", file=sys.stderr)
        return REFUSED
    held = [Held(place, path, size_of(path)) for place in PLACES if place.base != "desktop" for path in place.found()]
    if not options.data:
        _list(held, texts)
        return 0
    if (runs := running()) != []:
        print(f"day6-tui: {texts('uninstall.runs', what=_named(runs, texts))}", file=sys.stderr)
        return REFUSED
    wanted = [each for each in held if each.place.whose == "ours"]
    files = [each for each in held if each.place.whose == "user"]
    if not options.yes and not sys.stdin.isatty():
        print(f"day6-tui: {texts('uninstall.nobody')}", file=sys.stderr)
        return BAD_USAGE
    removed = _remove(wanted, "data", texts, options.yes)
    if options.files:
        removed = _remove(files, "files", texts, options.yes) and removed
    elif files:
        _table(texts("uninstall.kept"), files, texts)
    _how_to_remove_the_package(texts)
    return 0 if removed else NOT_REMOVED


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui uninstall`."""
    parser = command_parser("uninstall", language)
    texts = parser.texts
    parser.add_argument("--data", action="store_true", help=texts("cli.uninstall.data"))
    parser.add_argument("--files", action="store_true", help=texts("cli.uninstall.files"))
    parser.add_argument("-y", "--yes", action="store_true", help=texts("cli.uninstall.yes"))
    return parser


def _list(held: list[Held], texts: Texts) -> None:
    for whose in ("ours", "user", "ros"):
        some = [each for each in held if each.place.whose == whose]
        if some or whose == "ours":
            _table(texts(f"uninstall.{whose}"), some, texts)
    print(texts("uninstall.named"))
    print()
    _how_to_remove_the_package(texts)


def _table(title: str, held: list[Held], texts: Texts) -> None:
    print(title)
    width = max((text_width(each.shown) for each in held), default=0)
    for each in held:
        blanks = " " * (width - text_width(each.shown))
        print(f"  {each.shown}{blanks}  {each.size!s:>8}  {said(each.place.text, texts.language)}")
        if each.place.whose == "user":
            print(f"    {_removal(each)}")
    if not held:
        print(f"  {texts('uninstall.nothing')}")
    print()


def _removal(held: Held) -> str:
    """The command that removes what is the user's."""
    if os.name == "nt":
        return f'rmdir /s "{held.path}"' if held.path.is_dir() else f'del "{held.path}"'
    return one_line(f"rm -r {quoted(shortened(held.path))}")


def _remove(held: list[Held], kind: str, texts: Texts, yes: bool) -> bool:
    """Remove these, after a question; return whether all of it is gone."""
    if not held:
        print(texts(f"uninstall.{kind}.none"))
        return True
    _table(texts(f"uninstall.{kind}.these"), held, texts)
    total = Size(sum(each.size.bytes for each in held))
    if not yes and not _agrees(texts(f"uninstall.{kind}.ask", size=total)):
        print(texts("uninstall.left"))
        return False
    whole = True
    for each in held:
        left = remove(each.place, each.path)
        for path in left.foreign:
            print(one_line(texts("uninstall.foreign", path=shortened(path))))
        for error in left.failed:
            whole = False
            where = shortened(str(error.filename or each.path))
            print(one_line(f"day6-tui: {where}: {reason(error)}"), file=sys.stderr)
    _remove_empty([data_folder(), *(each.path.parent for each in held)])
    rest = sum(size_of(each.path).bytes for each in held if os.path.lexists(each.path))
    print(texts(f"uninstall.{kind}.done", size=Size(total.bytes - rest)))
    print()
    return whole


def _agrees(question: str) -> bool:
    try:
        return input(f"{question} ").strip().lower() in ("y", "yes", "是")
    except (EOFError, KeyboardInterrupt):
        print()
        return False


def _remove_empty(folders: Iterable[Path]) -> None:
    """Remove those of our own folders (day6-tui, day6-1000 …) in which nothing is left."""
    for folder in dict.fromkeys(folders):
        if folder.name.startswith("day6") and folder.is_dir() and not folder.is_symlink() and not os.listdir(folder):
            folder.rmdir()


def _named(runs: Iterable[Running], texts: Texts) -> str:
    said = (texts(f"uninstall.runs.{each.kind}", pid=each.pid, domain=each.domain) for each in runs)
    return texts("uninstall.comma").join(said)


def _how_to_remove_the_package(texts: Texts) -> None:
    found = installation()
    command = found.removal()
    if command:
        print(texts("uninstall.package"))
        print(f"  {one_line(command)}")
    if found.source is not None:
        print(texts("uninstall.checkout", folder=one_line(shortened(found.source))))
