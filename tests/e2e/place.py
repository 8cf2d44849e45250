"""Where a user works in a test: home, working folder and link folder of one's own, and what can be started there."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from day6_core.virtual.surroundings import is_there
from tests.support.short_folder import make_short_folder
from tests.support.waiting import PATIENCE, run, until

if TYPE_CHECKING:
    from tests.e2e.terminal import Terminal

_SCRIPT = shutil.which("day6-tui", path=os.path.dirname(sys.executable))
DAY6 = [_SCRIPT] if _SCRIPT else [sys.executable, "-m", "day6_tui.main"]


PLANTED = "import sys\nfrom day6_tui.main import main\nsys.argv[1:] = {words!r}\n{plant}\nsys.exit(main())\n"


class Place:
    """Where one user works: `work` is the current folder, `home` the simulated one."""

    def __init__(self, work: Path) -> None:
        self.work = work / "work"
        self.home = work / "home"
        self.work.mkdir()
        self.runtime = make_short_folder("d6e2e-")
        self.link: str | None = None
        """DAY6_LINK."""

    def environment(self, **more: str | None) -> dict[str, str | None]:
        """What differs from this process's variables; None stands for "not set"."""
        return {"DAY6_LINK": self.link, "DAY6_RUNTIME_DIR": str(self.runtime), **more}

    def variables(self, **more: str | None) -> dict[str, str]:
        merged = {**os.environ, **self.environment(**more)}
        return {name: value for name, value in merged.items() if value is not None}

    # -- without a screen ----------------------------------------------------------------------------------------------

    def run(self, *words: str, stdin: str | None = "", **env: str | None) -> subprocess.CompletedProcess[str]:
        """Run `day6-tui WORDS…` to its end."""
        return run([*DAY6, *words], stdin, cwd=self.work, env=self.variables(**env))

    def execute(self, commands: str, *more: str, **env: str | None) -> subprocess.CompletedProcess[str]:
        """Run lines of the simulated terminal by `day6-tui exec`."""
        return self.run("exec", "--home", str(self.home), "-c", commands, *more, **env)

    def play(self, commands: str) -> subprocess.CompletedProcess[str]:
        """The same where it isn't about real time: in virtual time, if there is any here."""
        return self.execute(commands, *["--fast"] * is_there())

    def start(self, *words: str, **env: str | None) -> subprocess.Popen[str]:
        """Start `day6-tui WORDS…`; it is killed at the end of the test if it still runs."""
        return subprocess.Popen(
            [*DAY6, *words],
            cwd=self.work,
            env=self.variables(**env),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def nodes(self) -> list[str]:
        """What `ros2 node list` says in a real terminal now."""
        return self.run("ros2", "node", "list").stdout.split()

    def wait_nodes(self, *names: str, limit: float = PATIENCE) -> None:
        """Ask `ros2 node list` until it names exactly these."""
        until(lambda: self.nodes() == sorted(names), limit)

    # -- with a screen -------------------------------------------------------------------------------------------------

    def terminal(self, *words: str, columns: int = 80, rows: int = 24, plant: str = "", **env: str | None) -> Terminal:
        """`day6-tui WORDS…` in a real terminal, after lines of Python that `plant` something; skips where there are none."""
        if os.name != "posix":
            pytest.skip("this system has no pseudo-terminals to try the screen in")
        from tests.e2e.terminal import Terminal

        command = [sys.executable, "-c", PLANTED.format(words=words, plant=plant)] if plant else [*DAY6, *words]
        return Terminal(command, columns, rows, cwd=self.work, env=self.environment(**env))

    def desktop(
        self,
        *options: str,
        columns: int = 80,
        rows: int = 24,
        lang: str = "en",
        plant: str = "",
        **env: str | None,
    ) -> Terminal:
        """The desktop in a real terminal."""
        language = ["--lang", lang] if lang else []
        home = [] if "--home" in options else ["--home", str(self.home)]
        return self.terminal(*home, *language, *options, columns=columns, rows=rows, plant=plant, **env)

    # -- what is there -------------------------------------------------------------------------------------------------

    def file(self, name: str, text: str) -> Path:
        """Write a file into the working folder (where `exec` and real terminals are)."""
        path = self.work / name
        path.write_text(text, encoding="utf-8")
        return path

    def home_file(self, name: str, text: str) -> Path:
        """Write a file into the home folder of the simulated terminals."""
        self.home.mkdir(exist_ok=True)
        path = self.home / name
        path.write_text(text, encoding="utf-8")
        return path

    def processes(self) -> dict[int, str]:
        """Every process that was started here and runs, with its command line; {} where the system does not tell."""
        mark = f"DAY6_RUNTIME_DIR={self.runtime}".encode()
        return self.started(lambda environment: mark in environment.split(b"\0"))

    @staticmethod
    def started(with_: Callable[[bytes], bool]) -> dict[int, str]:
        """Every process that runs and was started with such an environment, with its command line; as above."""
        found = {}
        for entry in Path("/proc").glob("[0-9]*") if sys.platform == "linux" else ():
            with contextlib.suppress(OSError):
                if with_((entry / "environ").read_bytes()):
                    found[int(entry.name)] = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode().strip()
        return found

    def close(self) -> None:
        for pid in self.processes():
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        shutil.rmtree(self.runtime, ignore_errors=True)
