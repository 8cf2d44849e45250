"""`day6-tui exec` and the other commands, as processes of their own, in a real terminal where that matters."""

from __future__ import annotations

import os
import select
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.link.paths import process_exists
from tests.support.waiting import Deadline, run, until

pytestmark = pytest.mark.process

MAIN = [sys.executable, "-m", "day6_tui.main"]
posix = pytest.mark.skipif(os.name != "posix", reason="needs signals and ptys")


def day6(*arguments: str, cwd: Path, stdin: str = "") -> subprocess.CompletedProcess[str]:
    return run([*MAIN, *arguments], stdin, cwd=cwd)


@pytest.fixture(autouse=True)
def own_home(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))


def test_exec_prints_what_the_terminal_would_and_exits_with_the_last_status(tmp_path: Path) -> None:
    result = day6("exec", "-c", "echo out; echo err >&2; cd nowhere; (exit 7)", cwd=tmp_path)
    assert result.stdout == "out\n"
    assert result.stderr == "err\nbash: cd: nowhere: No such file or directory\n"
    assert result.returncode == 7


def test_exec_begins_where_it_was_called_and_has_a_home_of_its_own(tmp_path: Path) -> None:
    result = day6("exec", "-c", "pwd; cd; pwd; ls", cwd=tmp_path)
    assert result.stdout.splitlines() == [str(tmp_path), str(tmp_path / "data" / "day6-tui" / "home"), "ros2_ws"]
    elsewhere = day6("exec", "--home", "h", "-c", "cd; pwd", cwd=tmp_path)
    assert elsewhere.stdout == f"{tmp_path / 'h'}\n"


def test_exec_runs_a_file_with_arguments_or_standard_input(tmp_path: Path) -> None:
    (tmp_path / "lesson.sh").write_text("echo $1-$2\n")
    assert day6("exec", "lesson.sh", "a", "b", cwd=tmp_path).stdout == "a-b\n"
    assert day6("exec", cwd=tmp_path, stdin="echo from\necho input\n").stdout == "from\ninput\n"
    assert day6("exec", "-c", "cat; read x", cwd=tmp_path, stdin="typed\n").stdout == "typed\n"


WHY = {
    # What failed before `why` -> its card.
    "ros2 run turtlesm turtlesim_node": "No package is called turtlesm, but there is turtlesim",
    "ls nothing": "There is no file or folder nothing",
    "ros2 topic lsit": "did you mean list?",
    "python3 slip.py": "nothing is called cuont here; did you mean count?",
    "(ls nothing)": "There is no file or folder nothing",
    "ls nothing 2>&1 | cat": "There is no file or folder nothing",
    "ls nothing\necho then": "There is no file or folder nothing",
    "python3 nothing.py": "There is no file or folder",
}


@pytest.mark.parametrize("line", WHY)
@pytest.mark.parametrize("then", ["; why", "\nwhy", " || true; if true; then why; fi"])
def test_why_in_exec_explains_what_the_script_printed(tmp_path: Path, line: str, then: str) -> None:
    (tmp_path / "slip.py").write_text("count = 1\nprint(cuont)\n")
    result = day6("exec", "--home", "h", "-c", f"{line}{then}", cwd=tmp_path)
    told = " ".join(result.stdout.split())
    assert (result.returncode, WHY[line].lower() in told.lower()) == (0, True), result


def test_why_in_exec_explains_each_failure_once_and_else_reads_what_is_piped_in(tmp_path: Path) -> None:
    script = "ls nothing; why; cat missing 2>/dev/null; ls second; why > card; why > again; echo $?; cat card"
    result = day6("exec", "--home", "h", "-c", script, cwd=tmp_path)
    assert result.stdout.count("no file or folder nothing") == 1 == result.stdout.count("no file or folder second")
    assert "\n1\n" in result.stdout and result.stderr.endswith("has printed lately\n")  # `why > again` has nothing left
    piped = day6(
        "exec", "--home", "h", "-c", "why", cwd=tmp_path, stdin="ls: cannot access 'x': No such file or directory\n"
    )
    assert "no file or folder x" in piped.stdout
    nothing = day6("exec", "--home", "h", "-c", "true; why", cwd=tmp_path)
    assert nothing.returncode == 1 and "no card" in nothing.stderr


def test_exec_without_its_file_says_so(tmp_path: Path) -> None:
    result = day6("exec", "nowhere.sh", cwd=tmp_path)
    assert (result.returncode, result.stderr) == (127, "day6-tui exec: nowhere.sh: No such file or directory\n")


def test_exec_with_a_home_that_cannot_be_says_so(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    result = day6("exec", "--home", "file", "-c", "true", cwd=tmp_path)
    assert result.returncode == 2
    assert result.stderr == "day6-tui exec: error: argument --home: 'file' isn't a folder, and can't become one\n"
    (tmp_path / "home").mkdir()
    (tmp_path / "home" / "ros2_ws").touch()
    result = day6("exec", "--home", "home", "-c", "true", cwd=tmp_path)
    assert result.returncode == 1
    assert result.stderr.startswith("day6-tui exec: the home folder cannot be used: ")
    assert "Traceback" not in result.stderr


def test_exec_ends_after_its_timeout_with_status_124(tmp_path: Path) -> None:
    assert day6("exec", "--timeout", "0.2", "-c", "sleep 9999", cwd=tmp_path).returncode == 124


def test_jobs_timeout_and_kill_work_in_exec(tmp_path: Path) -> None:
    lines = "sleep 100 & jobs; kill %1; wait %1; echo $?; timeout 0.1 sleep 5; echo $?; sleep 50 &"
    result = day6("exec", "-c", lines, cwd=tmp_path)
    assert result.stdout.splitlines() == ["[1]+  Running                 sleep 100 &", "143", "124"]
    assert result.returncode == 0


def test_a_subshell_lists_the_jobs_of_the_shell_around_it(tmp_path: Path) -> None:
    lines = "sleep 50 & sleep 60 & jobs | wc -l; echo $(jobs | grep -c Running); (sleep 40 & jobs)"
    expected = ["2", "2", "[1]+  Running                 sleep 40 &"]
    assert day6("exec", "-c", lines, cwd=tmp_path).stdout.splitlines() == expected


def test_sleep_is_paced_by_the_wall(tmp_path: Path) -> None:
    start = time.monotonic()
    day6("exec", "-c", "sleep 0.5", cwd=tmp_path)
    assert time.monotonic() - start >= 0.5


def test_a_reader_that_goes_away_ends_exec_without_a_word(tmp_path: Path) -> None:
    exec_ = subprocess.Popen(
        [*MAIN, "exec", "-c", "seq 1000000"], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert exec_.stdout is not None and exec_.stderr is not None
    assert exec_.stdout.readline() == b"1\n"
    exec_.stdout.close()
    assert status(exec_) == 141
    assert exec_.stderr.read() == b""
    exec_.stderr.close()


@posix
def test_ctrl_c_ends_the_line_and_what_runs_in_the_background(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("import os, time\nprint(os.getpid(), flush=True)\ntime.sleep(1000)\n")
    exec_ = subprocess.Popen(
        [*MAIN, "exec", "-c", "python3 a.py & sleep 1000; echo never"], cwd=tmp_path, stdout=subprocess.PIPE, text=True
    )
    assert exec_.stdout is not None
    pid = int(exec_.stdout.readline())
    exec_.send_signal(signal.SIGINT)
    assert status(exec_) == 130
    assert exec_.stdout.read() == ""
    exec_.stdout.close()
    until(lambda: not process_exists(pid))


def test_python_becomes_python3_with_our_packages(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("import sys, rclpy\nprint(sys.argv, rclpy.__name__)\nsys.exit(5)\n")
    result = day6("python", "a.py", "--flag", "x", cwd=tmp_path)
    assert (result.returncode, result.stdout) == (5, "['a.py', '--flag', 'x'] rclpy\n")
    missing = day6("python", "nowhere.py", cwd=tmp_path)
    assert missing.returncode == 2
    assert "can't open file" in missing.stderr


def test_an_unknown_command_is_told_in_one_line(tmp_path: Path) -> None:
    result = day6("turtle", cwd=tmp_path)
    assert (result.returncode, result.stderr) == (
        2,
        "day6-tui: there is no command 'turtle'; day6-tui --help lists them\n",
    )


def test_env_prints_lines_that_a_shell_can_evaluate(tmp_path: Path) -> None:
    script = f'eval "$({shlex.quote(sys.executable)} -m day6_tui.main env)"; python3 -c "import rclpy; print(rclpy.__file__)"'
    if os.name != "posix":
        pytest.skip("needs a POSIX shell")
    env = {**os.environ, "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
    result = subprocess.run(["sh", "-c", script], cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert result.stdout.rstrip().endswith(os.path.join("ros", "python", "rclpy", "__init__.py"))


@posix
def test_the_sub_shell_has_ros2_and_our_python(tmp_path: Path) -> None:
    env = {**os.environ, "SHELL": "/bin/sh"}
    commands = "command -v ros2; python3 -c 'import rclpy; print(rclpy.__name__)'; exit 3\n"
    result = subprocess.run(
        [*MAIN, "shell"], cwd=tmp_path, env=env, input=commands, capture_output=True, text=True, check=False
    )
    assert result.returncode == 3
    assert result.stdout.splitlines()[0].endswith("/ros2")
    assert result.stdout.splitlines()[1] == "rclpy"


def status(process: subprocess.Popen[bytes] | subprocess.Popen[str]) -> int:
    """The status of a process that ends."""
    until(lambda: process.poll() is not None)
    return process.returncode


class RealTerminal:
    """A pty with one of our commands on it."""

    def __init__(self, *arguments: str, cwd: Path) -> None:
        import pty

        self.master, slave = pty.openpty()
        self.process = subprocess.Popen(
            [*MAIN, *arguments], cwd=cwd, stdin=slave, stdout=slave, stderr=slave, start_new_session=True
        )
        os.close(slave)
        self.seen = ""

    def wait(self, text: str) -> str:
        deadline = Deadline()
        while text not in self.seen:
            assert not deadline.is_over(), f"no {text!r} in:\n{self.seen}"
            if select.select([self.master], [], [], 0.1)[0]:
                try:
                    self.seen += os.read(self.master, 65536).decode("utf-8", "replace")
                except OSError:
                    assert text in self.seen, f"it ended; no {text!r} in:\n{self.seen}"
        return self.seen

    def type(self, text: str) -> None:
        os.write(self.master, text.encode())

    def close(self) -> None:
        self.process.kill()
        self.process.wait()
        os.close(self.master)


@pytest.fixture
def teleop(tmp_path: Path) -> Iterator[RealTerminal]:
    lines = (
        "ros2 run turtlesim turtlesim_node & sleep 0.5; ros2 run turtlesim turtle_teleop_key; sleep 1.1; "
        "ros2 topic echo --once /turtle1/pose"
    )
    terminal = RealTerminal("exec", "-c", lines, cwd=tmp_path)
    yield terminal
    terminal.close()


@posix
def test_one_key_press_in_a_real_terminal_moves_the_turtle_for_63_ticks(teleop: RealTerminal) -> None:
    import termios

    teleop.wait("'q' to quit.")
    assert not termios.tcgetattr(teleop.master)[3] & termios.ECHO
    teleop.type("\x1b[A")
    teleop.type("q")
    teleop.wait("x: 7.560444355010986")
    assert status(teleop.process) == 0
    assert termios.tcgetattr(teleop.master)[3] & termios.ECHO


@posix
def test_the_headless_example_prints_the_real_answers(tmp_path: Path) -> None:
    lines = (
        "ros2 run turtlesim turtlesim_node & sleep 1; "
        'ros2 topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0}, angular: {z: 1.8}}"; '
        "sleep 2; ros2 topic echo --once /turtle1/pose; ros2 node list"
    )
    result = day6("exec", "-c", lines, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert "x: 6.602816581726074\ny: 6.938989639282227\ntheta: 1.8143999576568604\n" in result.stdout
    assert result.stdout.endswith("---\n/turtlesim\n")


@posix
def test_ctrl_c_in_a_real_terminal_ends_a_ros2_command(tmp_path: Path) -> None:
    terminal = RealTerminal("exec", "-c", "ros2 topic pub -r 20 /a std_msgs/msg/String; echo ended $?", cwd=tmp_path)
    try:
        terminal.wait("publishing #2")
        terminal.process.send_signal(signal.SIGINT)
        terminal.wait("ended 2")
        assert status(terminal.process) == 0
        assert "Traceback" not in terminal.seen
    finally:
        terminal.close()


def test_ros2_answers_in_a_real_terminal(tmp_path: Path) -> None:
    result = day6("ros2", "topic", "list", cwd=tmp_path)
    assert (result.returncode, result.stdout) == (0, "/parameter_events\n/rosout\n")
    wrong = day6("ros2", "run", "nowhere", "nothing", cwd=tmp_path)
    assert (wrong.returncode, wrong.stderr) == (1, "Package 'nowhere' not found\n")


def test_a_script_without_ros_loads_nothing_heavy(tmp_path: Path) -> None:
    script = (
        "import sys\nfrom day6_core.shell.outward.execute import main\n"
        "main(['-c', 'echo hi | grep h; python3 -c pass'])\n"
        "heavy = {'numpy', 'asyncio', 'yaml', 'textual', 'rich', 'zenoh', 'pyte', 'rclpy'}\n"
        "print(sorted(heavy & {name.split('.')[0] for name in sys.modules}))\n"
    )
    result = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert result.stdout == "hi\n[]\n", result.stderr


def test_without_a_screen_no_terminal_opens(tmp_path: Path) -> None:
    result = day6("exec", "-c", "xterm -e ls; echo $?; gnome-terminal -- ls; echo $?", cwd=tmp_path)
    assert result.stdout == "1\n1\n"
    assert result.stderr.startswith("xterm: Xt error: Can't open display: \n")
