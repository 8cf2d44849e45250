"""A simulated machine with an empty workspace. Builds are real, so its clock is the wall's."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from day6_core.session.program import Program
from day6_core.session.session import Session
from day6_core.session.streams import Captured, InputStream
from day6_core.shell.desk import Desk
from day6_core.shell.language.control_flow import ExitShell, Interrupted
from day6_core.shell.language.interpreter import Shell
from day6_core.shell.language.redirection import Streams
from tests.support.waiting import PATIENCE, until

"""Seconds a command may take at most."""

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):

    def __init__(self):
        super().__init__('day6_talker')
        self.publisher_ = self.create_publisher(String, 'chatter', 10)
        self.timer = self.create_timer(0.5, self.tick)
        self.count = 0

    def tick(self):
        msg = String()
        msg.data = 'Hello from Day 6: %d' % self.count
        self.publisher_.publish(msg)
        self.get_logger().info('Publishing: %s' % msg.data)
        self.count += 1


def main(args=None):
    rclpy.init(args=args)
    node = Talker()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""


class Result(NamedTuple):
    status: int
    out: str
    err: str


class Running(NamedTuple):
    """A script that runs; its output so far is in `out.text` and `err.text`."""

    program: Program
    out: Captured
    err: Captured


class Workshop:
    """`run` runs lines in a new terminal each time, in `~/ros2_ws`; `terminal()` keeps one."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(home, join_link=False, display=False)
        self.home = self.desk.home
        self.workspace = self.home / "ros2_ws"

    def close(self) -> None:
        self.desk.close()

    def terminal(self, cwd: Path | None = None) -> Shell:
        shell = self.desk.shell(cwd=cwd or self.workspace)
        shell.variables["COLUMNS"] = "80"
        shell.variables.export("COLUMNS")
        return shell

    def start(self, commands: str, shell: Shell | None = None) -> Running:
        used = shell or self.terminal()
        out, err = Captured(), Captured()
        streams = Streams(InputStream(), out, err)

        async def script(session: Session) -> int:
            session.on_interrupt = used.interrupt
            try:
                return await used.run(commands, streams)
            except ExitShell as end:
                return end.status
            except Interrupted:
                raise KeyboardInterrupt from None

        program = self.desk.start_program(["bash"], script, streams, env=used.environment, cwd=used.cwd, shell=used)
        return Running(program, out, err)

    def wait(self, condition, patience: float = PATIENCE) -> None:
        """Let programs and processes work until the condition holds."""
        until(lambda: self.desk.scheduler.run(condition, 0.02), patience, every=0.0)

    def run(self, commands: str, shell: Shell | None = None) -> Result:
        running = self.start(commands, shell)
        self.wait(lambda: running.program.status is not None)
        assert running.program.status is not None
        return Result(running.program.status, running.out.text, running.err.text)

    # -- packages ------------------------------------------------------------------------------------------------------

    def create(self, name: str, *more: str) -> Path:
        """Make an ament_python package in `src`."""
        words = " ".join(more)
        done = self.run(
            f"ros2 pkg create --build-type ament_python {name} {words}", self.terminal(self.workspace / "src")
        )
        assert done.status == 0, done
        return self.workspace / "src" / name

    def publisher(self, *, entry_point: bool = True) -> Path:
        """The package of the lesson: day6_publisher with talker.py, and (if asked) its entry point."""
        package = self.create("day6_publisher", "--dependencies rclpy std_msgs")
        (package / "day6_publisher" / "talker.py").write_text(TALKER, encoding="utf-8")
        if entry_point:
            edit(
                package / "setup.py",
                "'console_scripts': [\n",
                "'console_scripts': [\n            'talker = day6_publisher.talker:main',\n",
            )
        return package

    def tree(self, *roots: str) -> list[str]:
        """Return the paths below folders of the workspace, as the recordings name them."""
        found = []
        for root in roots:
            for path in sorted((self.workspace / root).rglob("*")):
                if "__pycache__" in path.parts:
                    continue
                shown = path.relative_to(self.workspace).as_posix()
                if path.is_symlink():
                    shown += f" -> {path.readlink()}"
                elif path.is_dir():
                    shown += "/"
                found.append(shown)
        return found


def edit(path: Path, before: str, after: str) -> None:
    """Replace a piece of a file that must be in it."""
    text = path.read_text(encoding="utf-8")
    assert before in text, f"{before!r} is not in {path}:\n{text}"
    path.write_text(text.replace(before, after), encoding="utf-8")
