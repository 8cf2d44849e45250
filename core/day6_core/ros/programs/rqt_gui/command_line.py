"""The command lines of rqt and of its plugins (qt_gui's main.py)."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from day6_core.session.argument_parser import SessionParser

if TYPE_CHECKING:
    from day6_core.session.session import Session


def container_parser(session: Session) -> SessionParser:
    """The options of `rqt`, without those that operate on another rqt by D-Bus."""
    parser = SessionParser(session, prog="rqt", add_help=False)
    group = _add_common(parser)
    group.add_argument("-p", "--perspective", metavar="PERSPECTIVE", help="start with this named perspective")
    group.add_argument("--perspective-file", metavar="PERSPECTIVE_FILE",
                       help="start with a perspective loaded from a file")  # fmt: skip
    group.add_argument("-s", "--standalone", metavar="PLUGIN",
                       help="start only this plugin (implies -l). To pass arguments to the plugin use --args")  # fmt: skip
    for option in (("-f", "--freeze-layout"), ("-l", "--lock-perspective")):
        group.add_argument(*option, action="store_true", help=argparse.SUPPRESS)
    group = parser.add_argument_group("Options to query information without starting a GUI instance")
    group.add_argument("--list-perspectives", action="store_true", help="list available perspectives")
    group.add_argument("--list-plugins", action="store_true", help="list available plugins")
    return parser


def plugin_parser(session: Session, prog: str, add_arguments: Callable[[SessionParser], None]) -> SessionParser:
    """The options of a plugin that runs alone: every one's, and its own, which `add_arguments` adds."""
    parser = SessionParser(session, prog=prog, add_help=False)
    _add_common(parser)
    add_arguments(parser)
    return parser


def _add_common(parser: SessionParser) -> argparse._ArgumentGroup:
    """Add what every program of rqt takes. What is about Qt and its window is taken and not told: it changes nothing here."""
    group = parser.add_argument_group("Options for GUI instance")
    group.add_argument("--clear-config", action="store_true",
                       help="clear the configuration (including all perspectives and plugin settings)")  # fmt: skip
    group.add_argument("--force-discover", action="store_true", help="force a rediscover of plugins")
    group.add_argument("-h", "--help", action="help", help="show this help message and exit")
    group.add_argument("-b", "--qt-binding", help=argparse.SUPPRESS)
    for option in (("-ht", "--hide-title"), ("--reload-import",), ("-t", "--on-top"), ("-v", "--verbose")):
        group.add_argument(*option, action="store_true", help=argparse.SUPPRESS)
    return group


def own_words(argv: Sequence[str]) -> list[str]:
    """The words of a command line that are neither the program's name nor ROS's arguments."""
    words = list(argv[1:])
    return words[: words.index("--ros-args")] if "--ros-args" in words else words
