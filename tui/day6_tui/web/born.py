"""The process that desktops are forked from: `python -I -m day6_tui.web.born DESCRIPTOR ROOM`, which `nursery.Nursery` starts.

It has imported what a desktop imports and knows nothing else: no variable, file or word of the server's or a pupil's, as it forks
before it reads what is asked for. The child goes the same way as a desktop that is started singly (`orphan`, `enter`, the keeper,
the desktop); but where that becomes another program, this goes on as it, in a process that by then is the pupil's.
"""

from __future__ import annotations

import gc
import importlib
import json
import os
import signal
import socket
import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, NoReturn

from day6_core.isolation import enter, shown
from day6_tui.detached import keeper
from day6_tui.distribution_choice import KEEPER
from day6_tui.web.nursery import LARGEST, MOST_DESCRIPTORS, READY

assert not TYPE_CHECKING or sys.platform == "linux"

_MODULES = (
    "day6_tui.app",
    "day6_tui.main",
    "day6_tui.commands.desktop",
    "day6_core.shell.desk",
    "day6_core.shell.outside",
    "day6_core.ros.programs",
    "day6_core.ros.ros2.run",
    "zenoh",
)
"""With all that they import: what nearly every desktop needs. None of them starts a thread or looks at the user's files."""

_FIRST_FREE = 512
"""Descriptors from here on are nobody's, unless one of the server's has such a number."""

_FAILED = 126
"""As `enter` ends where it cannot go in."""


def main(words: list[str]) -> int:
    """Fork desktops until the server has gone; returns the exit status."""
    control = socket.socket(fileno=int(words[0]))
    words_shown = shown.ShownWords()
    words_shown.show([sys.executable, "-I", "-m", "day6_tui.web.born"])
    for module in _MODULES:
        importlib.import_module(module)
    gc.collect()
    gc.freeze()  # or the first collection of every child would copy all that it shares
    while True:
        message, descriptors, _, _ = socket.recv_fds(control, 1, 1)
        if not message:
            return 0
        child = os.fork()
        if child == 0:
            control.close()
            _Child(words_shown).begin(descriptors[0])
        os.close(descriptors[0])
        os.waitpid(child, 0)


class _Child:
    """What a child does, one after the other. Nothing returns to the parent's code."""

    def __init__(self, words: shown.ShownWords) -> None:
        self._shown = words

    def begin(self, descriptor: int) -> NoReturn:
        """Be nobody's child, read what is asked for, and go into the cell."""
        status = _FAILED
        try:
            if os.fork():
                os._exit(0)
            os.setsid()
            with socket.socket(fileno=descriptor) as request:
                request.send(READY)
                data, given, _, _ = socket.recv_fds(request, LARGEST, MOST_DESCRIPTORS)
            if data:  # else the server waits no longer
                order = json.loads(data)
                _place(given, order["descriptors"])
                _set_environment(order["environment"])
                self._shown.show(order["shown"])
                status = enter.enter(enter.SandboxPlan(**order["plan"]), order["keeper"], self._keeper)
        finally:
            os._exit(status)

    def _keeper(self, argv: list[str], environment: Mapping[str, str]) -> NoReturn:
        _set_environment(environment)
        self._shown.show(argv)
        keeper.main(argv[argv.index(keeper.__name__) + 1 :], self._desktop)
        os._exit(0)

    def _desktop(self, argv: list[str], environment: Mapping[str, str]) -> NoReturn:
        """On the terminal that the keeper has made; what a new program would not have is taken away."""
        from day6_tui import main as program

        enter.close_others([int(environment[KEEPER].partition(":")[0])])
        signal.set_wakeup_fd(-1)
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)
        _set_environment(environment)
        self._shown.show(argv)
        sys.orig_argv = list(argv)
        sys.argv = [str(program.__file__), *argv[argv.index(program.__name__) + 1 :]]
        for number, name in enumerate(("stdin", "stdout", "stderr")):
            old = getattr(sys, name)
            new = open(number, old.mode, encoding=old.encoding, errors=old.errors, closefd=False)  # noqa: SIM115
            setattr(sys, name, new)
            setattr(sys, f"__{name}__", new)
        status = 1
        try:
            status = program.main()
        except SystemExit as error:
            status = error.code if isinstance(error.code, int) else 1
        except BaseException:
            sys.excepthook(*sys.exc_info())
        os._exit(status)


def _place(given: list[int], wanted: list[int]) -> None:
    """Give the descriptors that came the numbers they have at the server; no other stays open."""
    import fcntl

    free = max(_FIRST_FREE, *wanted) + 1
    high = [fcntl.fcntl(number, fcntl.F_DUPFD, free) for number in given]
    enter.close_others(high)
    for number, goal in zip(high, wanted, strict=True):
        os.dup2(number, goal)
        os.close(number)


def _set_environment(environment: Mapping[str, str]) -> None:
    os.environ.clear()
    os.environ.update(environment)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
