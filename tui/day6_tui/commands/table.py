"""Every sub-command of `day6-tui`, once: dispatch, help, completion, the man page and the reference are made from this.

Nothing of a command is imported before it is called or explained.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from day6_core.command_line.parser import CommandParser

GROUPS = ("desktop", "lessons", "programs", "ros", "own")
"""In which `day6-tui --help` lists the commands, in this order; a heading is the text `cli.group.<group>`."""

_ROS = "day6_tui.commands.ros"


class Command(NamedTuple):
    """One sub-command."""

    name: str
    """'' is the desktop, which opens without a command."""
    group: str
    """One of GROUPS; '' for one that is not listed."""
    module: str
    main: str = "main"
    """The function in the module that is called with the words behind the command (in `ros`, with the command before them)."""
    parsers: str = ""
    """`module:function` of the parser, if it is not the module's `build_parser`."""
    is_desktop: bool = False
    """Whether it opens the desktop, and takes its options."""

    def run(self, words: list[str]) -> int:
        """Call it; return the exit status."""
        if self.group == "lessons":  # which know classes of messages
            from day6_core.ros.environment import activate

            activate()
        main = getattr(import_module(self.module), self.main)
        status: int = main([self.name, *words] if self.group == "ros" else words)
        return status

    def parser(self, language: str) -> CommandParser | None:
        """Its parser in a language; None for a command of ROS, whose help is that of ROS."""
        if self.group == "ros":
            return None
        module, _, function = (self.parsers or f"{self.module}:build_parser").partition(":")
        found: CommandParser = getattr(import_module(module), function)(language)
        return found

    def summary(self, language: str) -> str:
        """What it is for, in one line: the first of its description."""
        from day6_core.command_line.texts import texts_in

        return texts_in(language)[f"cli.{self.name or 'desktop'}"].partition("\n")[0].rstrip(".。")


_OWN = (
    Command("", "", "day6_tui.commands.desktop", is_desktop=True),
    Command("attach", "desktop", "day6_tui.detached.client"),
    Command("demo", "desktop", "day6_tui.commands.demo", is_desktop=True),
    Command("class", "desktop", "day6_tui.classes.command", is_desktop=True),
    Command("serve", "desktop", "day6_tui.web.command", parsers="day6_tui.web.options:build_parser"),
    Command("wheelhouse", "desktop", "day6_tui.wheelhouse.command"),
    Command("lessons", "lessons", "day6_core.lessons.command", parsers="day6_core.lessons.parsers:lessons"),
    Command("submit", "lessons", "day6_core.lessons.submission", parsers="day6_core.lessons.parsers:submit"),
    Command("grade", "lessons", "day6_core.lessons.grading.command", parsers="day6_core.lessons.parsers:grade"),
    Command("report", "lessons", "day6_core.lessons.report", parsers="day6_core.lessons.parsers:report"),
    Command("shell", "programs", "day6_core.shell.outward.subshell"),
    Command("env", "programs", "day6_core.shell.outward.variables"),
    Command("exec", "programs", "day6_core.shell.outward.execute"),
    Command("python", "programs", "day6_core.shell.outward.python_file"),
    Command("test", "programs", "day6_core.workspace.run_tests"),
    Command("export", "programs", "day6_core.workspace.export"),
    Command("why", "programs", "day6_tui.commands.why"),
    Command("cast", "programs", "day6_tui.cast.command"),
    Command("bag-csv", "programs", "day6_tui.commands.bag_csv"),
    Command("launch-plan", "programs", "day6_tui.commands.launch_plan"),
    Command("ros2", "ros", _ROS, "ros2"),
    Command("colcon", "ros", _ROS, "colcon"),
    Command("help", "own", "day6_tui.commands.help"),
    Command("doctor", "own", "day6_tui.upkeep.doctor"),
    Command("uninstall", "own", "day6_tui.upkeep.uninstall"),
    Command("completion", "own", "day6_tui.commands.completion"),
    Command("complete", "", "day6_tui.commands.complete"),
)
_BY_NAME = {command.name: command for command in _OWN}


def commands() -> Iterator[Command]:
    """Yield all that are shown, the desktop first, in the order in which they are listed."""
    from day6_core.ros.program_index import COMMANDS

    yield _BY_NAME[""]
    for group in GROUPS:
        yield from (command for command in _OWN if command.group == group)
        if group == "ros":
            yield from map(_program, COMMANDS)


def names() -> list[str]:
    """Return what may stand behind `day6-tui`: the names of all that are shown, without the desktop, which has none."""
    return [command.name for command in commands() if command.name]


def command_named(name: str) -> Command | None:
    """Return the one with a name, None if there is none."""
    if (found := _BY_NAME.get(name)) is not None:
        return found
    from day6_core.ros.program_index import COMMANDS

    return _program(name) if name in COMMANDS else None


def _program(name: str) -> Command:
    """rqt_graph, rviz2, check_urdf …, which are commands of their own in ROS, too."""
    return Command(name, "ros", _ROS, "program")
