"""The state of one shell: its variables, working directory, options, arguments, and the special parameters (`$?`, `$!` …)."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from day6_core.shell.language.syntax import Function

MAX_DEPTH = 100
"""How deep `source`, `( )` and `$( )` may nest, so that a file that sources itself ends with a message."""
NOT_FOUND = 127
"""The status of a command that does not exist."""


class ShellState:
    """The state of one shell, without its jobs. `name` is the prefix of its messages (`bash: …`)."""

    def __init__(self, *, env: dict[str, str], cwd: Path, interactive: bool, name: str, pid: int) -> None:
        self.variables = env
        self.exported = set(env)
        self.cwd = cwd
        self.interactive = interactive
        self.name = name
        self.zero = name
        """The value of `$0`: the name of the script being run."""
        self.arguments: list[str] = []
        self.options: set[str] = set()
        """Of `set`: 'e' ends the shell at the first failing command, 'x' shows each command, 'u' refuses unset variables."""
        self.aliases = {"ll": "ls -alF", "la": "ls -A", "l": "ls -CF"}
        """As Ubuntu's .bashrc defines them, until there is another."""
        self.functions: dict[str, Function] = {}
        self.settings = {"checkwinsize", "cmdhist", "expand_aliases"}
        """Of `shopt`."""
        self.hidden: list[dict[str, str | None]] = []
        """For each running function, the values that its `local` variables had before (None: not set)."""
        self.folders: list[str] = []
        """The directory stack of `pushd`, the newest first."""
        self.status = 0
        self.pid = pid
        self.unbound_status = 1 if interactive else NOT_FOUND
        """The status of a command or a whole script after `${x:?}`: 127 only in the text after `-c`."""
        self.last_background = 0
        self.history: list[str] = []
        self.depth = 0
        self.subshell = False
        self.background = False
        """Whether it runs a job that was started with `&`."""

    @property
    def environment(self) -> dict[str, str]:
        """The exported variables, which programs started here inherit."""
        return {name: value for name, value in self.variables.items() if name in self.exported}

    @property
    def short_cwd(self) -> str:
        """The working directory with `~` for the home folder."""
        home = self.variables.get("HOME", "")
        cwd = str(self.cwd)
        if home and (cwd == home or cwd.startswith(home + os.sep)):
            return "~" + cwd[len(home) :]
        return cwd

    def parameter(self, name: str) -> str | None:
        """The value of `$name`, special parameters included; None if it is not set."""
        special: dict[str, Callable[[], str]] = {
            "?": lambda: str(self.status),
            "$": lambda: str(self.pid),
            "!": lambda: str(self.last_background) if self.last_background else "",
            "#": lambda: str(len(self.arguments)),
            "@": lambda: " ".join(self.arguments),
            "*": lambda: " ".join(self.arguments),
            "-": lambda: "hiB" if self.interactive else "hB",
            "0": lambda: self.zero,
        }
        if name in special:
            return special[name]()
        if name.isdigit():
            index = int(name)
            return self.arguments[index - 1] if index <= len(self.arguments) else None
        return self.variables.get(name)

    @property
    def too_deep(self) -> str:
        return f"{self.name}: maximum nesting level exceeded ({MAX_DEPTH})"

    def inherit(self, parent: ShellState) -> None:
        """Become what a subshell of `parent` starts with."""
        self.exported = set(parent.exported)
        self.arguments = list(parent.arguments)
        self.zero = parent.zero
        self.options = set(parent.options)
        self.aliases = dict(parent.aliases)
        self.settings = set(parent.settings)
        self.folders = list(parent.folders)
        self.functions = dict(parent.functions)
        self.hidden = [dict(each) for each in parent.hidden]
        self.status = parent.status
        self.pid = parent.pid
        self.last_background = parent.last_background
        self.history = parent.history
        self.depth = parent.depth + 1
        self.subshell = True
        self.background = parent.background
