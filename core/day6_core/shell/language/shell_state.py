"""The state of one shell: its variables, working directory, options, arguments, and the special parameters (`$?`, `$!` …)."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

from day6_core.shell.language.settings import FIRST_OPTIONS, FIRST_SETTINGS, LETTERS
from day6_core.shell.language.specials import Call
from day6_core.shell.language.syntax import Function
from day6_core.shell.language.variables import Cell, Variables

MAX_DEPTH = 100
"""How deep `source`, `( )` and `$( )` may nest, so that a file that sources itself ends with a message."""
NOT_FOUND = 127
"""The status of a command that does not exist."""


class ShellState:
    """The state of one shell, without its jobs. `name` is the prefix of its messages (`bash: …`)."""

    def __init__(self, *, env: Mapping[str, str], cwd: Path, interactive: bool, name: str, pid: int) -> None:
        self.variables = Variables(env)
        self.cwd = cwd
        self.interactive = interactive
        self.name = name
        self.zero = name
        """The value of `$0`: the name of the script being run."""
        self.script = ""
        """The name of the file that is run; '' for the text after -c and for what is typed."""
        self.last_argument = name
        """`$_`: the last argument of the command before."""
        self.line = 1
        """The number of the line that runs."""
        self.calls: list[Call] = []
        """Functions that run and files that are sourced, the innermost last."""
        self.arguments: list[str] = []
        self.options: set[str] = set(FIRST_OPTIONS)
        """Of `set`: 'e' ends the shell at the first failing command, 'x' shows each command, 'u' refuses unset variables."""
        self.aliases = {"ll": "ls -alF", "la": "ls -A", "l": "ls -CF"}
        """As Ubuntu's .bashrc defines them, until there is another."""
        self.functions: dict[str, Function] = {}
        self.exported_functions: set[str] = set()
        self.wanted_distribution: str | None = None
        """Another distribution that a line has sourced, '' before; None where it cannot be changed."""
        self.settings = set(FIRST_SETTINGS)
        """Of `shopt`."""
        self.hidden: list[dict[str, Cell | None]] = []
        """For each running function, the variables that its `local` ones hide (None: not set)."""
        self.traps: dict[str, str] = {}
        """By the name of the signal, or EXIT and ERR."""
        self.completions: dict[str, str] = {}
        """By the name of a command: the options that `complete` was given for it."""
        self.folders: list[str] = []
        """The directory stack of `pushd`, the newest first."""
        self.status = 0
        self.pid = pid
        self.own_pid = pid
        """The number of this very shell, where `$$` is that of the one around its subshells."""
        self.level = 0
        """How many subshells it is in."""
        self.loops = 0
        """How many loops run, as far as `break` can see them."""
        self.option_index, self.option_place = 1, 1
        """Where `getopts` goes on: the argument, and the character in it."""
        self.started_ns = 0
        """When SECONDS was 0."""
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
        return self.variables.exported

    @property
    def separators(self) -> str:
        """The characters of IFS."""
        return self.variables.get("IFS", " \t\n")

    @property
    def short_cwd(self) -> str:
        """The working directory with `~` for the home folder."""
        home = self.variables.get("HOME", "")
        cwd = str(self.cwd)
        if home and (cwd == home or cwd.startswith(home + os.sep)):
            return "~" + cwd[len(home) :].replace(os.sep, "/")
        return cwd

    def parameter(self, name: str) -> str | None:
        """The value of `$name`, special parameters included; None if it is not set."""
        special: dict[str, Callable[[], str | None]] = {
            "?": lambda: str(self.status),
            "$": lambda: str(self.pid),
            "!": lambda: str(self.last_background) if self.last_background else None,
            "#": lambda: str(len(self.arguments)),
            "@": lambda: " ".join(self.arguments),
            "*": lambda: " ".join(self.arguments),
            "-": lambda: "".join(
                letter for letter in LETTERS if letter in self.options or (letter == "i" and self.interactive)
            ),
            "0": lambda: self.zero,
        }
        if name in special:
            return special[name]()
        if name.isdigit():
            index = int(name)
            return self.arguments[index - 1] if index <= len(self.arguments) else None
        return self.variables.get(name)

    def variable_names(self) -> list[str]:
        """Names of the variables that are set."""
        return [*self.variables, *(name for name in self.variables.dynamic if name not in self.variables.cells)]

    def frames(self) -> list[Call]:
        """What runs, from the innermost to the script."""
        return [*reversed(self.calls), *([Call("main", self.script, 0)] if self.script else [])]

    @property
    def file(self) -> str:
        """The file that what runs is in."""
        return self.calls[-1].file if self.calls else self.script

    @property
    def too_deep(self) -> str:
        return f"{self.name}: maximum nesting level exceeded ({MAX_DEPTH})"

    def inherit(self, parent: ShellState) -> None:
        """Become what a subshell of `parent` starts with."""
        self.variables.copy_from(parent.variables)
        self.arguments = list(parent.arguments)
        self.zero = parent.zero
        self.script = parent.script
        self.line = parent.line
        self.last_argument = parent.last_argument
        self.calls = list(parent.calls)
        self.options = set(parent.options)
        self.aliases = dict(parent.aliases)
        self.settings = set(parent.settings)
        self.folders = list(parent.folders)
        self.functions = dict(parent.functions)
        self.exported_functions = set(parent.exported_functions)
        self.hidden = [dict(each) for each in parent.hidden]
        self.traps = {
            name: text for name, text in parent.traps.items() if not text or (name == "ERR" and "E" in parent.options)
        }
        self.status = parent.status
        self.pid = parent.pid
        self.level = parent.level + 1
        self.loops = parent.loops
        self.option_index, self.option_place = parent.option_index, parent.option_place
        self.started_ns = parent.started_ns
        self.last_background = parent.last_background
        self.history = parent.history
        self.depth = parent.depth + 1
        self.subshell = True
        self.background = parent.background
