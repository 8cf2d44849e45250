"""The options of `day6-tui`, explained in the user's language."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from functools import partial
from pathlib import Path

from day6_core.language import LANGUAGES
from day6_core.lessons.scene import scenes
from day6_core.ros.distribution import NAMES
from day6_tui.appearance import themes
from day6_tui.locale import Texts


def build_parser(language: str = "en") -> argparse.ArgumentParser:
    """The options of the desktop."""
    texts = Texts(language)
    parser, options = parser_with_options(texts, "day6-tui", "cli.description")
    parser.epilog = f"{texts('cli.commands')}\n\n{texts('cli.more')}"
    options.add_argument("--scene", choices=tuple(scenes()), help=texts("cli.scene"))
    options.add_argument("--robot", metavar="FILE", help=texts("cli.robot"))
    options.add_argument("--distro", choices=NAMES, help=texts("cli.distro"))
    options.add_argument("--lang", choices=LANGUAGES, help=texts("cli.lang"))
    options.add_argument("--glyphs", choices=("pixels", "half", "braille", "cell", "ascii"), help=texts("cli.glyphs"))
    options.add_argument("--theme", choices=themes.NAMES, help=texts("cli.theme"))
    options.add_argument("--fps", type=_frame_rate, metavar="N", help=texts("cli.fps"))
    options.add_argument("--reduced-motion", action="store_true", help=texts("cli.reduced_motion"))
    options.add_argument("--home", type=Path, metavar="DIR", help=texts("cli.home"))
    options.add_argument("--lessons", type=folder, metavar="DIR", help=texts("cli.lessons"))
    options.add_argument("--lesson", metavar="NAME", help=texts("cli.lesson"))
    options.add_argument("--demo", action="store_true", help=argparse.SUPPRESS)
    options.add_argument("--record", type=Path, metavar="FILE.cast", help=texts("cli.record"))
    options.add_argument("--detach", action="store_true", help=texts("cli.detach"))
    options.add_argument(
        "--listen", type=partial(_endpoint, listening=True), metavar="ENDPOINT", help=texts("cli.listen")
    )
    options.add_argument(
        "--connect", type=partial(_endpoint, listening=False), metavar="ENDPOINT", help=texts("cli.connect")
    )
    options.add_argument("--secret", type=_secret, metavar="FILE|WORD", help=texts("cli.secret"))
    options.add_argument("--version", action="store_true", help=texts("cli.version"))
    return parser


def attach_parser(language: str = "en") -> argparse.ArgumentParser:
    """The options of `day6-tui attach`."""
    texts = Texts(language)
    parser, options = parser_with_options(texts, "day6-tui attach", "cli.attach")
    options.add_argument("--home", type=Path, metavar="DIR", help=texts("cli.attach.home"))
    options.add_argument("--lang", choices=LANGUAGES, help=texts("cli.attach.lang"))
    return parser


def parser_with_options(
    texts: Texts, prog: str, description: str
) -> tuple[argparse.ArgumentParser, argparse._ArgumentGroup]:
    """A parser in the language of `texts`, of which `description` is a key, and its group of options, with `--help`."""
    parser = argparse.ArgumentParser(
        prog=prog,
        description=texts(description),
        formatter_class=partial(_Formatter, usage=texts("cli.usage")),
        add_help=False,
    )
    options = parser.add_argument_group(texts("cli.options"))
    options.add_argument("-h", "--help", action="help", help=texts("cli.help"))
    return parser, options


class _Formatter(argparse.RawDescriptionHelpFormatter):
    """Folds by terminal cells, of which a Chinese character takes two."""

    def __init__(self, prog: str, *, usage: str) -> None:
        super().__init__(prog)
        self._usage = usage
        self._headings: list[str] = []

    def add_usage(
        self,
        usage: str | None,
        actions: Iterable[argparse.Action],
        groups: Iterable[argparse._MutuallyExclusiveGroup],
        prefix: str | None = None,
    ) -> None:
        super().add_usage(usage, actions, groups, self._usage if prefix is None else prefix)

    def start_section(self, heading: str | None) -> None:
        self._headings.append(heading or "")
        super().start_section(heading)

    def format_help(self) -> str:
        """Put the colon of the language behind the headings, where argparse has its own."""
        text, colon = super().format_help(), self._usage.rstrip()[-1:]
        for heading in filter(None, self._headings):
            text = text.replace(f"\n{heading}:\n", f"\n{heading}{colon}\n")
        return text

    def _split_lines(self, text: str, width: int) -> list[str]:
        from day6_tui.panes.cells import wrap

        return wrap(text, width)


def folder(text: str) -> Path:
    path = Path(text).expanduser()
    if not path.is_dir():
        raise argparse.ArgumentTypeError(f"'{text}' is no folder")
    return path.resolve()


def _frame_rate(text: str) -> float:
    try:
        rate = float(text)
    except ValueError:
        rate = 0.0
    if not 1 <= rate <= 120:
        raise argparse.ArgumentTypeError(f"'{text}' is no number from 1 to 120")
    return rate


def _endpoint(text: str, *, listening: bool) -> str:
    from day6_core.link.addresses import address_of

    try:
        address_of(text, listening=listening)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text


def _secret(text: str) -> str:
    from day6_core.link.secret import secret_of

    try:
        return secret_of(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
