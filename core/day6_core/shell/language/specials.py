"""Variables whose value is worked out when it is asked for: RANDOM, SECONDS, LINENO, FUNCNAME, BASH_SOURCE, UID …"""

from __future__ import annotations

import os
import platform
from dataclasses import dataclass
from typing import TYPE_CHECKING

from day6_core.shell.language.settings import NAMED_OPTIONS
from day6_core.shell.language.variables import Cell, Variables

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell

VERSION = ("5", "2", "15", "1", "release")
"""Of the bash that this shell is like."""


@dataclass(frozen=True)
class Call:
    """A function that runs, or a file that is sourced: its name, the file it is in, and the line it was called from."""

    name: str
    file: str
    line: int


class RandomNumbers:
    """bash's own generator (lib/sh/random.c), so that `RANDOM=42` gives the same numbers."""

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self.last = 0

    def next(self) -> int:
        while True:
            high, low = divmod(self.seed or 123459876, 127773)
            value = 16807 * low - 2836 * high
            self.seed = value + 0x7FFFFFFF if value < 0 else value
            found = ((self.seed >> 16) ^ (self.seed & 65535)) & 32767
            if found != self.last:
                self.last = found
                return found


def add_specials(shell: Shell) -> None:
    """Give a shell these variables."""
    variables = shell.variables
    clock = shell.desk.clock
    numbers = RandomNumbers(int.from_bytes(os.urandom(4), "little"))
    shell.started_ns = clock.now_ns()

    def seed(text: str) -> None:
        numbers.seed, numbers.last = (int(text) if text.lstrip("-").isdigit() else 0) & 0xFFFFFFFF, 0

    def restart(text: str) -> None:
        shell.started_ns = clock.now_ns() - (int(text) if text.lstrip("-").isdigit() else 0) * 10**9

    def options() -> str:
        return ":".join(name for name, letter in NAMED_OPTIONS.items() if letter in shell.options)

    variables.dynamic.update(
        {
            "RANDOM": lambda: str(numbers.next()),
            "SRANDOM": lambda: str(int.from_bytes(os.urandom(4), "little")),
            "SECONDS": lambda: str((clock.now_ns() - shell.started_ns) // 10**9),
            "EPOCHSECONDS": lambda: str(clock.now_ns() // 10**9),
            "EPOCHREALTIME": lambda: f"{clock.now_ns() / 1e9:.6f}",
            "_": lambda: shell.last_argument,
            "LINENO": lambda: str(shell.line),
            "BASHPID": lambda: str(shell.own_pid),
            "BASH_SUBSHELL": lambda: str(shell.level),
            "FUNCNAME": lambda: [call.name for call in shell.frames()] if shell.hidden else [],
            "BASH_SOURCE": lambda: [call.file for call in shell.frames()],
            "BASH_LINENO": lambda: [str(call.line) for call in shell.frames()],
            "DIRSTACK": lambda: [str(shell.cwd), *shell.folders],
            "SHELLOPTS": options,
            "BASHOPTS": lambda: ":".join(sorted(shell.settings)),
        }
    )
    variables.on_assignment.update({"RANDOM": seed, "SECONDS": restart})
    user = str(getattr(os, "getuid", lambda: 1000)())
    machine = platform.machine() or "x86_64"
    for name, text in {"UID": user, "EUID": user, "PPID": str(os.getppid())}.items():
        variables.cells[name] = Cell(text, attributes={"i", "r"})
    for name, text in {
        "BASH": "/usr/bin/bash", "BASH_VERSION": "{}.{}.{}({})-{}".format(*VERSION), "HOSTTYPE": machine, "IFS": " \t\n",
        "MACHTYPE": f"{machine}-pc-linux-gnu", "OPTERR": "1", "OPTIND": "1", "OSTYPE": "linux-gnu", "PS4": "+ ",
    }.items():  # fmt: skip
        variables.cells.setdefault(name, Cell(text))
    variables.cells["IFS"] = Cell(" \t\n")
    versions = {str(at): text for at, text in enumerate((*VERSION, f"{machine}-pc-linux-gnu"))}
    variables.cells["BASH_VERSINFO"] = Cell(items=versions, attributes={"a", "r"})
    variables.cells["GROUPS"] = Cell(items={"0": str(getattr(os, "getgid", lambda: 1000)())}, attributes={"a"})


def copy_specials(shell: Shell, parent: Variables) -> None:
    """After the variables of a subshell were copied: those unset in the parent stay unset."""
    for name in list(shell.variables.dynamic):
        if name not in parent.dynamic:
            shell.variables.dynamic.pop(name)
