"""`ros2 run rqt_py_console rqt_py_console`: lines of Python, one after the other.

The real one runs them in rqt itself, where `while True: pass` is the end of all windows, and closes after `exit()`. Here they run
in a Python of their own, as a program that is started in the terminal from which rqt was. A real terminal has no such desktop
for us: then the window says so. Without a screen it is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from day6_core.reason import named_reason
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, run_alone
from day6_core.ros.programs.rqt_py_common.command_lines import Kind, Printed
from day6_core.ros.programs.rqt_py_console.model import NO_DESKTOP, PyConsole
from day6_core.session.session import Session
from day6_core.session.streams import Pipe
from day6_core.session.task import Signal

INTERPRETER = Path(__file__).with_name("interpreter.py")


class PyConsolePlugin(Plugin[PyConsole]):
    """rqt_py_console/PyConsole. (The real one is a plugin of Qt alone and has no node.)"""

    kind, title = "rqt_py_console", "PyConsole"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, PyConsole())
        self._wanted = Signal()
        self.model.on_begin = self._wanted.set

    async def run(self) -> None:
        while True:
            self.model.ended(await self._run())
            await self.place.session.wait(self._wanted)
            self._wanted.clear()

    async def _run(self) -> int | None:
        """Run one interpreter to its end; return its status, None if there can be none."""
        session, model = self.place.session, self.model
        host = session.host
        python = host.command("python3") if host is not None and host.starts_programs else None
        if host is None or python is None:
            model.take(f"{NO_DESKTOP}\n", Kind.REMARK)
            return None
        keys, output = Pipe(), Printed(model.take_stream)
        argv = ["python3", "-u", str(INTERPRETER)]
        try:
            program = host.start_beside(
                argv, python, output, output, env=dict(session.env), cwd=session.cwd, stdin=keys.reader
            )
        except OSError as error:
            model.take(f"{named_reason(error)}\n", Kind.ERROR)
            return 1

        def send(text: str) -> None:
            with suppress(BrokenPipeError):  # it has just ended
                keys.writer.write(text)
            if not text:
                keys.writer.close()

        model.began(send, program.interrupt)
        try:
            return await program.wait()
        finally:
            program.kill()  # also when the plugin is closed meanwhile


async def main(session: Session) -> int | None:
    """Open the window and run what is typed into it."""
    return await run_alone(session, PyConsolePlugin)
