"""`day6-tui wheelhouse DIR`: reads the options, fetches, and says what was done."""

from __future__ import annotations

import importlib.util
import os
import sys
import tempfile
from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import language_of
from day6_core.reason import named_reason, reason
from day6_core.session.harmless import one_line
from day6_tui.locale import Texts
from day6_tui.wheelhouse import closure, folder, own_wheel
from day6_tui.wheelhouse.guide import checker, guide, listed
from day6_tui.wheelhouse.targets import PLATFORMS, PYTHONS, Target, this_platform, this_python

EXTRAS = ("serve",)
"""A teacher's machine may want them."""


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui wheelhouse`, and what it takes."""
    parser = command_parser("wheelhouse", language)
    texts, add = parser.texts, parser.add_argument
    add("folder", type=Path, metavar="DIR", help=texts("cli.wheelhouse.folder"))
    add(
        "--platform",
        action="append",
        choices=tuple(PLATFORMS),
        metavar="NAME",
        help=texts("cli.wheelhouse.platform"),
    )
    add("--python", action="append", choices=PYTHONS, metavar="VERSION", help=texts("cli.wheelhouse.python"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui wheelhouse DIR [--platform P …] [--python V …]`; returns the exit status."""
    language = language_of(os.environ, words)
    options = build_parser(language).parse_args(words)
    texts = Texts(language)
    here = this_platform()
    if not here and not options.platform:
        return _refuse(texts("wheelhouse.no_platform"), 2)
    if importlib.util.find_spec("pip") is None:
        return _refuse(texts("wheelhouse.no_pip", command=f"{sys.executable} -m ensurepip"), 1)
    platforms = options.platform or [here]
    targets = [Target(PLATFORMS[each], python) for each in platforms for python in options.python or [this_python()]]
    try:
        if name := folder.foreign(options.folder):
            raise folder.NotOurs(name)
        folder.try_to_write(options.folder)
        with tempfile.TemporaryDirectory(prefix="day6-wheelhouse-") as place:
            wheels, pinned = _fetch(targets, Path(place))
            texts_beside = {folder.GUIDE: guide(targets), folder.CHECK: checker(targets), folder.LIST: pinned}
            folder.fill(options.folder, wheels, texts_beside)
    except folder.NotOurs as error:
        return _refuse(texts("wheelhouse.foreign", file=options.folder / str(error)), 1)
    except closure.NoInternet as error:
        return _refuse(texts("wheelhouse.no_internet", reason=error), 1)
    except (closure.FetchError, own_wheel.WheelError) as error:
        return _refuse(texts("wheelhouse.failed", reason=error), 1)
    except OSError as error:
        return _refuse(named_reason(error), 1)
    size = sum(path.stat().st_size for path in options.folder.iterdir())
    print(one_line(texts("wheelhouse.done", count=len(wheels), size=f"{size / 1e6:.0f}", folder=options.folder)))
    print(one_line(texts("wheelhouse.next", file=options.folder / folder.GUIDE)))
    return 0


def _fetch(targets: list[Target], place: Path) -> tuple[list[Path], str]:
    """Everything for all targets, in a folder of ours, of which errors name what it is in; with the list for pip."""
    own, others = place / "own", place / "others"
    names = dict[Target, set[str]]()
    try:
        own.mkdir()
        others.mkdir()
        wheel = own_wheel.make(own)
        for target in targets:
            names[target] = closure.fetch(wheel, EXTRAS, target, others, lambda line: print(one_line(line), flush=True))
    except OSError as error:
        raise closure.FetchError(f"{place.parent}: {reason(error)}") from error
    pinned = listed({target: {wheel.name, *found} for target, found in names.items()})
    return [wheel, *(others / name for name in sorted(set().union(*names.values())))], pinned


def _refuse(text: object, status: int) -> int:
    print(f"day6-tui wheelhouse: {one_line(str(text))}", file=sys.stderr)
    return status
