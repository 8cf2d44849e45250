"""Every window's pane is written for the model that its program hands over."""

from __future__ import annotations

import re
import typing
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.lessons.program import lessons_of
from day6_core.link.classroom.teacher import Teacher
from day6_core.ros.program_index import executables
from day6_core.ros.programs.rqt_gui.catalogue import KNOWN
from day6_core.ros.programs.rqt_gui.plugin import plugin_of
from day6_core.session.display import Window
from day6_core.session.streams import InputStream, OutputStream
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.subshells import subshell_main
from day6_tui.classes.link import TeacherLink
from day6_tui.classes.seen import Seen
from day6_tui.windows import WindowPane, pane_class
from tests.support.source_files import sources
from tests.support.window_kinds import window_kinds

OPENS = re.compile(r'\bdisplay\.open\("(\w+)"')


def opened_by_executables() -> Iterator[tuple[str, str]]:
    """Yield kind and command of the windows that an executable's own module opens."""
    for module, text in sources("day6_core/ros/programs"):
        package, name = module.parent.name, module.stem
        for kind in OPENS.findall(text):
            if name in executables(package):
                yield kind, f"ros2 run {package} {name}"


COMMANDS = {
    **dict(opened_by_executables()),
    **{plugin_of(entry.package).kind: f"ros2 run {entry.package} {entry.package}" for entry in KNOWN},
    "rqt": "rqt",
    "showimage": (
        "ros2 run image_tools showimage & ros2 run image_tools cam2image --ros-args -p burger_mode:=true > /dev/null 2>&1"
    ),
    "editor": "nano notes.txt",
}
"""What opens a window of each kind."""

STARTED = ("lesson", "classroom", "shown")
"""Windows that the desktop itself opens."""

LONGEST = 60.0


def model_of(kind: str) -> str:
    """The name of the model for which the pane of a kind is written."""
    bases = [base for cls in pane_class(kind).__mro__ for base in getattr(cls, "__orig_bases__", ())]
    origins = ((typing.get_origin(base), typing.get_args(base)) for base in bases)
    model, *_ = next(given for origin, given in origins if isinstance(origin, type) and issubclass(origin, WindowPane))
    return model.__forward_arg__ if isinstance(model, typing.ForwardRef) else model.__name__


def open_windows(home: Path) -> list[Window[object]]:
    """Run the command of every kind and return the windows that they open."""
    desk = Desk(home, join_link=False)
    try:
        shell = desk.shell(cwd=home)
        streams = Streams(InputStream(), OutputStream(), OutputStream())
        lines = "\n".join(f"{command} &" for command in COMMANDS.values()) + "\nwait\n"
        main = subshell_main(shell, lambda: shell.run(lines, streams))
        desk.start_program(["bash"], main, streams, env=shell.environment, cwd=home, shell=shell)
        desk.start_program(["lesson"], lessons_of(desk, "anna", None), streams, env=shell.environment, cwd=home)
        desk.start_program(["classroom"], TeacherLink(Teacher()).main, streams, env=shell.environment, cwd=home)
        desk.start_program(["shown"], Seen(None).main, streams, env=shell.environment, cwd=home)  # type: ignore[arg-type]
        display = desk.display
        assert display is not None
        desk.scheduler.run(lambda: len(display.windows) == len(window_kinds()), LONGEST)
        return display.windows
    finally:
        desk.hurry()
        desk.close()


@pytest.mark.process
def test_a_pane_is_typed_with_the_model_that_its_program_hands_over(tmp_path) -> None:
    assert {*COMMANDS, *STARTED} == {*window_kinds()}
    handed_over = {window.kind: type(window.model).__name__ for window in open_windows(tmp_path)}
    assert handed_over == {kind: model_of(kind) for kind in window_kinds()}
