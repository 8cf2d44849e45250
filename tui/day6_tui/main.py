"""The `day6-tui` command: determines which part was requested, and imports only that."""

from __future__ import annotations

import errno
import os
import signal
import sys
import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.commands.table import Command


READER_GONE = 128 + 13
"""As in a shell: ended by SIGPIPE."""


def main(arguments: list[str] | None = None) -> int:
    """Entry point of `day6-tui`; returns the exit status."""
    if arguments is None:
        _end_silently_on_ctrl_c()
        threading.excepthook = _thread_failed
    from day6_core.session.harmless import guard_standard_streams

    words = sys.argv[1:] if arguments is None else arguments
    guard_standard_streams()
    try:
        try:
            return _obey(words, alone=arguments is None)
        finally:
            if sys.stdout is not None:
                sys.stdout.flush()
    except OSError as error:
        if arguments is not None or not _is_of_output(error):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # Python writes what is left when it ends
        if isinstance(error, BrokenPipeError):  # `day6-tui doctor | head -1`
            return READER_GONE
        print(f"day6-tui: write error: {error.strerror}", file=sys.stderr)  # as GNU programs say it
        return 1


def _is_of_output(error: OSError) -> bool:
    """Return whether standard output took no more: nobody reads it, or its disk is full. Errors of other files name them."""
    full = (errno.ENOSPC, errno.EFBIG, getattr(errno, "EDQUOT", errno.ENOSPC))
    return error.filename is None and (isinstance(error, BrokenPipeError) or error.errno in full)


def _obey(words: list[str], *, alone: bool) -> int:
    """Run the command that the words name; return its status. `alone`: nothing of this process is needed after it."""
    if words in (["-V"], ["--version"]):
        return show_version()
    from day6_tui.commands.table import command_named
    from day6_tui.distribution_choice import option_in, settle

    front, (name, *rest) = _from_command(words)
    if (command := command_named(name)) is None:
        return _no_command(name, words)
    distribution = None
    if front:
        language, distribution = _read(front, words)
        rest = _in_language(command, language, rest)
    settle(distribution or (option_in(rest) if command.is_desktop else None), rest)
    status = command.run(rest)
    if alone and command.is_desktop:
        from day6_core.session.ending import leave

        leave(status)
    return status


def _from_command(words: list[str]) -> tuple[list[str], list[str]]:
    """The options before the command, and the words from it on; without a command, all words are options of the desktop, ''."""
    if words and not words[0].startswith("-"):
        return [], words
    from day6_core.command_line.leading import DISTRIBUTION, LANGUAGE, leading

    front, rest = leading(words, (LANGUAGE, DISTRIBUTION))
    return (front, rest) if rest and not rest[0].startswith("-") else ([], ["", *words])


def _in_language(command: Command, language: str | None, words: list[str]) -> list[str]:
    """The words after a command, with the language that was named before it, if one was."""
    from day6_core.command_line.leading import LANGUAGE
    from day6_core.language import VARIABLE

    if language is None:
        return words
    if command.group != "ros":
        return [LANGUAGE, language, *words]
    os.environ[VARIABLE] = language  # for the hints below errors
    return words


def _read(front: list[str], words: list[str]) -> tuple[str | None, str | None]:
    """The language and the distribution that stand before a command, in the words. Raises SystemExit for a wrong one."""
    from day6_core.language import language_of
    from day6_tui.commands.desktop import build_parser

    chosen = build_parser(language_of(os.environ, words)).parse_args(front)
    return chosen.lang, chosen.distro


def _no_command(name: str, words: list[str]) -> int:
    """Say that there is none with this name, and which may have been meant; return the exit status."""
    from day6_core.command_line.parser import nearest
    from day6_core.command_line.texts import CommandTexts
    from day6_core.language import language_of
    from day6_core.session.harmless import one_line
    from day6_tui.commands.table import names

    texts = CommandTexts(language_of(os.environ, words))
    close = nearest(name, names())
    key = "cli.error.command" if close is None else "cli.error.command.close"
    print(one_line(f"day6-tui: {texts(key, name=name, close=close)}"), file=sys.stderr)
    return 2


def show_version() -> int:
    """Print it; return the exit status."""
    from importlib.metadata import version

    print(f"day6-tui {version('day6-tui')}")
    return 0


def _thread_failed(failure: threading.ExceptHookArgs) -> None:
    """Report an error in a thread of ours in one line, or in the log if there is one; Python would print a traceback."""
    error = failure.exc_value
    if error is None or isinstance(error, SystemExit):
        return
    logging = sys.modules.get("logging")
    if logging is not None and logging.getLogger().handlers:
        logging.getLogger("day6_tui").error(
            "the thread %s failed", failure.thread and failure.thread.name, exc_info=error
        )
    elif sys.stderr is not None:
        from day6_core.reason import fault

        print(f"day6-tui: {fault(error)}", file=sys.stderr)


def _end_silently_on_ctrl_c() -> None:
    """Until a handler is installed, let Ctrl-C end this process like a C program: without Python's traceback."""
    if (
        signal.getsignal(signal.SIGINT) is signal.default_int_handler
    ):  # not where it is ignored (`nohup`, a script's `&`)
        signal.signal(signal.SIGINT, signal.SIG_DFL)


if __name__ == "__main__":
    sys.exit(main())
