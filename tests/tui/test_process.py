"""The desktop as a process on a real pty: what it imports, how it ends, what it leaves behind."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.waiting import PATIENCE, run, until

ROOT = Path(__file__).resolve().parents[2]

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs a pty")


class Pty:
    """`day6-tui` in a terminal of its own."""

    def __init__(self, home: Path, *options: str, **environ: str) -> None:
        import fcntl
        import pty
        import struct
        import termios

        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        self.before = termios.tcgetattr(slave)
        self._slave, self._master = slave, master
        env = {**os.environ, "TERM": "xterm-256color", "LANG": "C.UTF-8", "DAY6_LINK": "off", **environ}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "day6_tui.main", "--home", str(home), "--lang", "en", *options],
            stdin=slave, stdout=slave, stderr=slave, env=env, cwd=ROOT, start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
        )  # fmt: skip
        self.output = b""

    def until(self, text: bytes) -> None:
        until(
            lambda: text in self.output, every=0, meanwhile=lambda: self._read(0.05), told=lambda: self.output[-2000:]
        )

    def _read(self, seconds: float) -> None:
        if select.select([self._master], [], [], seconds)[0]:
            self.output += os.read(self._master, 65536)

    def send(self, keys: bytes) -> None:
        os.write(self._master, keys)

    def wait(self, limit: float = PATIENCE) -> int:
        """Read on until the process has ended."""
        until(lambda: self.process.poll() is not None, limit, every=0, meanwhile=lambda: self._read(0.02))
        while select.select([self._master], [], [], 0)[0]:
            self.output += os.read(self._master, 65536)
        return self.process.returncode

    def modes(self) -> list[object]:
        import termios

        return termios.tcgetattr(self._slave)

    def hang_up(self) -> None:
        os.close(self._slave)
        os.close(self._master)


@pytest.fixture
def home(tmp_path: Path) -> Path:
    (tmp_path / "sleepy.py").write_text("import os, time\nprint('I am', os.getpid())\ntime.sleep(600)\n")
    return tmp_path


@pytest.mark.process
def test_quitting_restores_the_terminal_and_is_quick(home) -> None:
    terminal = Pty(home)
    terminal.until(b"student@day6")
    terminal.send(b"\x11")
    assert terminal.wait() == 0  # one that takes long is ended by force, with another status
    assert b"\x1b[?1049l" in terminal.output and b"\x1b[?25h" in terminal.output
    assert terminal.modes() == terminal.before


def _student_pid(terminal: Pty) -> int:
    terminal.send(b"python3 sleepy.py\r")
    terminal.until(b"I am ")
    terminal.until(b"I am " + terminal.output.split(b"I am ")[1][:1])

    def mine() -> list[int]:
        found = subprocess.run(["pgrep", "-f", "sleepy.py"], capture_output=True, text=True).stdout.split()
        return [int(pid) for pid in found if _home_of(int(pid)) == terminal_home(terminal)]

    return until(mine, every=0.02)[0]


def terminal_home(terminal: Pty) -> str:
    return terminal.process.args[terminal.process.args.index("--home") + 1]  # type: ignore[union-attr, index]


def _home_of(pid: int) -> str:
    try:
        variables = Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
    except OSError:
        return ""
    return next((value[5:].decode() for value in variables if value.startswith(b"HOME=")), "")


def _gone(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


@pytest.mark.process
@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="looks into /proc")
@pytest.mark.parametrize("end", ["quit", "SIGTERM", "hang up", "SIGKILL"])
def test_no_student_process_outlives_the_desktop(home, end) -> None:
    terminal = Pty(home, "--scene", "empty")
    terminal.until(b"student@day6")
    pid = _student_pid(terminal)
    if end == "quit":
        terminal.send(b"\x11y")
    elif end == "hang up":
        terminal.hang_up()
    else:
        terminal.process.send_signal(getattr(signal, end))
    if end == "hang up":
        until(lambda: terminal.process.poll() is not None, every=0.02)
    else:
        terminal.wait()
    until(lambda: _gone(pid), every=0.02)


@pytest.mark.process
def test_the_first_frame_needs_neither_numpy_nor_pygments_nor_the_link(home) -> None:
    code = (
        "import sys\n"
        "from day6_tui.options import Options\n"
        "from day6_tui.app import Day6App\n"
        "app = Day6App(Options(fps=0, lang='zh'))\n"
        "async def main():\n"
        "    app._open_desk = lambda: None\n"
        "    async with app.run_test(size=(80, 24)) as pilot:\n"
        "        app.screen._compositor.render_strips()\n"
        "        print(sorted({'numpy', 'pygments', 'zenoh', 'yaml', 'rclpy', 'yourdfpy', 'pyte'} & set(sys.modules)))\n"
        "import asyncio; asyncio.run(main())\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert done.stdout.strip() == "[]", done.stdout + done.stderr


@pytest.mark.process
def test_the_desktop_does_without_openssl_and_leaves_it_importable() -> None:
    code = (
        "import sys, day6_tui.app, asyncio\n"
        "print('ssl' in sys.modules)\n"
        "import ssl; print(ssl.create_default_context() is not None)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert done.stdout.split() == ["False", "True"], done.stderr


@pytest.mark.process
def test_without_a_terminal_it_says_so_and_what_to_use_instead(home) -> None:
    command = [sys.executable, "-m", "day6_tui.main", "--home", str(home)]
    done = run(command, stdin=subprocess.DEVNULL, cwd=ROOT)
    assert done.returncode != 0 and done.stdout == ""
    assert "the desktop needs a terminal" in done.stderr and "day6-tui exec" in done.stderr


@pytest.mark.parametrize(
    ("words", "variables", "said"),
    [
        (["--help"], {}, ["usage: day6-tui", "maximum frames per second"]),
        (["--lang", "zh", "--help"], {}, ["用法：day6-tui", "每秒最多画几帧", "编译和测试工作空间"]),
        (["--lang=en", "--help"], {"LANG": "zh_CN.UTF-8"}, ["usage: day6-tui"]),
        (["--help"], {"LANG": "zh_CN.UTF-8"}, ["用法：day6-tui"]),
        (["--help"], {"DAY6_LANG": "zh"}, ["用法：day6-tui"]),
        (["nope"], {"DAY6_LANG": "zh"}, ["没有叫 nope 的命令"]),
    ],
)
def test_the_command_line_speaks_the_language_of_the_user(monkeypatch, capfd, words, variables, said) -> None:
    from day6_tui.main import main

    monkeypatch.setenv("COLUMNS", "80")
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    try:
        main(words)
    except SystemExit as end:
        assert end.code == 0
    shown = "".join(capfd.readouterr())
    assert all(text in shown for text in said)


def test_the_command_line_knows_every_scene() -> None:
    from day6_core.lessons.scene import scenes
    from day6_tui.commands.desktop import build_parser

    (option,) = [action for action in build_parser()._actions if action.dest == "scene"]
    assert tuple(option.choices) == tuple(scenes())


@pytest.mark.process
def test_a_home_that_cannot_be_used_is_reported_after_the_terminal_is_restored(tmp_path) -> None:
    (tmp_path / "ros2_ws").write_text("")
    terminal = Pty(tmp_path)
    assert terminal.wait() == 1
    text = terminal.output.decode()
    assert "The home folder" in text.rpartition("\x1b[?1049l")[2]
    assert "Traceback" not in text
