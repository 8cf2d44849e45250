"""Where day6-tui runs in virtual time in a test, and what is left of it."""

from __future__ import annotations

import subprocess

from tests.e2e.place import DAY6, Place
from tests.support.waiting import communicate, until


class Running:
    """A world that runs, with its output in files, so that nobody waits for a line that never comes."""

    def __init__(self, world: World, commands: str, env: dict[str, str | None]) -> None:
        self._files = world.work / "stdout", world.work / "stderr"
        with self._files[0].open("w") as stdout, self._files[1].open("w") as stderr:
            self.process = subprocess.Popen(
                [*DAY6, "exec", "--fast", "--home", str(world.home), "-c", commands],
                cwd=world.work,
                env=world.variables(**env),
                stdin=subprocess.PIPE,
                stdout=stdout,
                stderr=stderr,
                text=True,
            )

    @property
    def out(self) -> str:
        return self._files[0].read_text(encoding="utf-8")

    @property
    def err(self) -> str:
        return self._files[1].read_text(encoding="utf-8")

    def wait_for(self, text: str) -> None:
        """Wait until a text has been written."""
        until(lambda: text in self.out + self.err, told=lambda: self.out + self.err)

    def end(self, typed: str | None = None, signal: int | None = None) -> int:
        """Type the last line, or send a signal, and wait for the end; return the status."""
        if signal is not None:
            self.process.send_signal(signal)
        communicate(self.process, typed)
        return int(self.process.returncode)


class World(Place):
    """A place in whose runtime folder the folders of worlds are."""

    def environment(self, **more: str | None) -> dict[str, str | None]:
        return super().environment(TMPDIR=str(self.runtime), TZ="UTC", PYTHONUNBUFFERED="1", **more)

    def python(self, program: str, *more: str, **env: str | None) -> subprocess.CompletedProcess[str]:
        """Run a program by `day6-tui python --fast`."""
        self.file("program.py", program)
        return self.run("python", "--fast", "program.py", *more, **env)

    def fast(self, commands: str, *more: str, **env: str | None) -> subprocess.CompletedProcess[str]:
        """Run lines of the simulated terminal by `day6-tui exec --fast`."""
        return self.execute(commands, "--fast", *more, **env)

    def begin(self, commands: str, **env: str | None) -> Running:
        """Start lines of the simulated terminal by `day6-tui exec --fast`."""
        return Running(self, commands, env)

    def left(self) -> list[str]:
        """Folders of worlds, and processes that were started in one and still run."""
        mark = f"={self.runtime}/".encode()
        started = self.started(lambda environment: mark in environment)
        return [*(path.name for path in self.runtime.glob("day6-time-*")), *started.values()]
