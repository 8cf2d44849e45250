"""`ros2 run rqt_shell rqt_shell`: a line for commands that end by themselves.

They run in the shell of the terminal in which rqt was started, without a keyboard. A real terminal has no such shell for us: then
the window says so. Without a screen it is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from functools import partial

from day6_core.reason import named_reason
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, run_alone
from day6_core.ros.programs.rqt_py_common.command_lines import Kind, Printed
from day6_core.ros.programs.rqt_shell.model import NO_DESKTOP, RqtShell
from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.session.task import Signal


class ShellPlugin(Plugin[RqtShell]):
    """rqt_shell/Shell. (The real one is a plugin of Qt alone and has no node.)"""

    kind, title = "rqt_shell", "SimpleShell"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, RqtShell())
        self._wanted = Signal()
        self._line = ""
        self._program: Program | None = None
        self.model.on_run = self._want
        self.model.on_interrupt = self._interrupt

    def _want(self, line: str) -> None:
        self._line = line
        self._wanted.set()

    def _interrupt(self) -> None:
        program = self._program
        if program is not None:
            program.interrupt()

    async def run(self) -> None:
        while True:
            await self.place.session.wait(self._wanted)
            self._wanted.clear()
            await self._run(self._line)
            self.model.ended()

    async def _run(self, line: str) -> None:
        session, model = self.place.session, self.model
        output, errors = (Printed(partial(model.take, kind=kind)) for kind in (Kind.OUTPUT, Kind.ERROR))
        host = session.host
        bash = host.command("bash") if host is not None and host.starts_programs else None
        if host is None or bash is None:
            model.take(f"{NO_DESKTOP}\n", Kind.REMARK)
            return
        try:
            self._program = host.start_beside(
                ["bash", "-c", line], bash, output, errors, env=dict(session.env), cwd=session.cwd
            )
        except OSError as error:
            errors.write(f"{named_reason(error)}\n")
            return
        try:
            await self._program.wait()
        finally:
            self._program.kill()  # also when the plugin is closed meanwhile
            self._program = None


async def main(session: Session) -> int | None:
    """Open the window and run what is typed into it."""
    return await run_alone(session, ShellPlugin)
