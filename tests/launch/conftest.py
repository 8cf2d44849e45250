"""Launches in this process (for what a launch does by itself) and on a simulated machine (for `ros2 launch`)."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.session.streams import Captured, TextInput
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from tests.support.waiting import until


@pytest.fixture(autouse=True)
def own_environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Log files below the test's folder; what a launch does to environment and loggers is undone."""
    import launch.logging

    before = dict(os.environ)
    level = logging.root.level
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    launch.logging.reset()
    yield
    launch.logging.reset()
    logging.root.setLevel(level)
    os.environ.clear()
    os.environ.update(before)


class Launched(NamedTuple):
    status: int
    lines: list[str]
    """What it wrote, without the two lines about logging."""


@pytest.fixture
def launch_these(capsys: pytest.CaptureFixture[str]) -> Callable[..., Launched]:
    """Launch entities in this process until everything has ended."""
    from launch import LaunchDescription, LaunchService

    def run(*entities: Any, **options: Any) -> Launched:
        service = LaunchService(noninteractive=True, **options)
        service.include_launch_description(LaunchDescription(list(entities)))
        status = service.run()
        return Launched(status, capsys.readouterr().out.splitlines()[2:])

    return run


class Machine:
    """A desk with a screen, in wall time, driven by the test's thread."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(home, domain_id=0, join_link=False, clock=WorldClock())
        self.out, self.err = Captured(), Captured()

    def streams(self) -> Streams:
        return Streams(TextInput(""), self.out, self.err)

    def start(self, commands: str) -> Program:
        shell = self.desk.shell()
        self.out, self.err = Captured(), Captured()
        streams = self.streams()

        async def script(session: Session) -> int:
            session.on_interrupt = shell.interrupt
            return await shell.run(commands, streams)

        return self.desk.start_program(["bash"], script, streams, env=shell.environment, cwd=shell.cwd, shell=shell)

    def wait(self, condition: Callable[[], bool]) -> None:
        until(
            lambda: self.desk.scheduler.run(condition, 0.05),
            every=0.0,
            told=lambda: f"{self.out.text}\n{self.err.text}",
        )

    def run(self, commands: str) -> tuple[int, str, str]:
        program = self.start(commands)
        self.wait(lambda: program.status is not None)
        assert program.status is not None
        return program.status, self.out.text, self.err.text

    def write(self, name: str, text: str) -> Path:
        path = self.desk.home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def install(self, package: str, **executables: str) -> Path:
        """Put a package with Python executables under ~/install; returns its share folder."""
        prefix = self.desk.home / "install"
        share = prefix / "share" / package
        share.mkdir(parents=True, exist_ok=True)
        (share / "package.xml").write_text(f"<package><name>{package}</name></package>")
        marker = prefix / "share" / "ament_index" / "resource_index" / "packages" / package
        marker.parent.mkdir(parents=True, exist_ok=True)
        marker.write_text("")
        for name, text in executables.items():
            path = prefix / "lib" / package / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"#!{sys.executable}\n{text}")
            path.chmod(0o755)
        return share


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    made = Machine(tmp_path / "home")
    yield made
    made.desk.close()
