"""What keeps the project running on Windows and macOS, as far as Linux can tell.

A Linux Python from which everything is taken that Windows lacks stands in for Windows; `.ci/check` adds the type checker's
view of both systems, which knows the names each of them has.
"""

from __future__ import annotations

import ast
import json
import ntpath
import os
import posixpath
import shutil
import subprocess
import sys
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

import pytest

from day6_core.places import as_on_linux
from day6_core.ros import executables
from day6_core.ros.environment import program_environment
from day6_core.session import signals
from day6_core.session.clock import WorldClock
from day6_core.session.scheduler import Scheduler
from day6_core.shell.builtins.files import folders_of
from day6_core.shell.desk import Desk
from day6_core.workspace.sourcing import source_setup
from tests.support.source_files import OF_DISTRIBUTIONS, ON_THE_PATH, PACKAGES, SHARE, nodes, sources, trees

OF_JAZZY = OF_DISTRIBUTIONS / "jazzy"

WITHOUT_UNIX = """
import asyncio, concurrent.futures, ctypes, importlib, json, logging.handlers, os, shutil, signal, subprocess, sys, tempfile
import textual.app, textual.screen, textual.widgets, yaml, numpy, zenoh

for name in "termios tty pty fcntl resource pwd grp syslog readline curses posix".split():
    sys.modules[name] = None
for name in "SIGKILL SIGSTOP SIGCONT SIGTSTP SIGHUP SIGQUIT SIGUSR1 SIGWINCH SIGCHLD SIGALRM SIGPIPE pthread_sigmask".split():
    delattr(signal, name)
waitpid = os.waitpid
for name in ("fork forkpty killpg getpgid setsid getuid geteuid getgid getppid uname nice wait waitpid mkfifo openpty fchmod "
             "register_at_fork sched_getaffinity sched_yield ttyname statvfs getloadavg").split():
    if name != "getppid":
        delattr(os, name)
"""
"""Libraries are loaded first: what they need on this system is not ours to take away."""


def module_names() -> list[str]:
    names = []
    for path in (path for base in PACKAGES.values() for path in sorted(base.rglob("*.py"))):
        if SHARE in path.parents or (OF_DISTRIBUTIONS in path.parents and OF_JAZZY not in path.parents):
            continue
        if 'if sys.platform != "linux":\n    raise ImportError(' in path.read_text(encoding="utf-8"):
            continue  # says so itself
        base = next(each for each in (ON_THE_PATH, OF_JAZZY, *PACKAGES.values()) if each in path.parents)
        parts = path.relative_to(base).with_suffix("").parts
        parts = parts[:-1] if parts[-1] == "__init__" else parts
        if parts[-1] != "__main__":
            names.append(".".join(parts))
    return names


def run(code: str, tmp_path: Path, **env: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", WITHOUT_UNIX + code],
        capture_output=True,
        encoding="utf-8",
        cwd=tmp_path,
        env={**program_environment(), "PYTHONIOENCODING": "utf-8", **env},
    )


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="takes away what is not there")
def test_every_module_imports_where_unix_is_missing(tmp_path: Path) -> None:
    code = f"""
failed = {{}}
for name in {module_names()!r}:
    try:
        importlib.import_module(name)
    except Exception as error:
        failed[name] = repr(error)
print(json.dumps(failed))
"""
    done = run(code, tmp_path)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[-1]) == {}


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="takes away what is not there")
def test_a_terminal_and_students_programs_do_without_unix(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text(
        "import sys, rclpy\n"
        "rclpy.init()\n"
        "rclpy.create_node('talker').get_logger().info('你好')\n"
        "for line in sys.stdin: print(line.strip().upper(), end='\\r\\n')\n"
        "rclpy.shutdown()\n",
        encoding="utf-8",
    )
    turtlesim = (
        "ros2 run turtlesim turtlesim_node & until ros2 node list | grep turtlesim; do sleep 0.05; done; kill %1"
    )
    script = f"echo one | python3 talker.py | grep -c 'ONE$'; {turtlesim}"
    code = f"""
os.waitpid = waitpid  # the system below is still this one, and `subprocess` waits by it
subprocess.CREATE_NEW_PROCESS_GROUP = subprocess.BELOW_NORMAL_PRIORITY_CLASS = 0
signal.CTRL_BREAK_EVENT = signal.SIGINT
here, sys.platform = sys.platform, "win32"
from day6_core.shell.outward.execute import main
status = main(["--home", {str(tmp_path)!r}, "-c", {script!r}])
sys.platform = here
sys.exit(status)
"""
    done = run(code, tmp_path, DAY6_LINK="off", LOCALAPPDATA=str(tmp_path))
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == ["1", "/turtlesim"], done.stderr
    assert "你好" in done.stderr


def test_text_is_read_and_written_as_utf8_everywhere() -> None:
    """Without `encoding` Windows takes the old code page, and a Chinese comment in a student's file ends the program."""
    offenders = []
    for path, tree in trees(words=("read_text", "write_text", "subprocess", "open")):
        for node in nodes(tree):
            if (
                isinstance(node, ast.Call)
                and _is_text(node)
                and not {"encoding"} & {each.arg for each in node.keywords}
            ):
                offenders.append(f"{path}:{node.lineno}: {ast.unparse(node)}")
    assert offenders == []


def test_programs_of_the_simulated_machine_never_take_the_real_home_for_theirs() -> None:
    """`Session.path` knows the home of a program's user; what asks this process finds the one of whoever runs day6-tui."""
    for path, text in sources("day6_core/ros/programs", "day6_core/ros/ros2"):
        assert "expanduser" not in text or path.name == "lone_daemon.py", path


def test_nobody_waits_for_some_time_at_a_queue_that_may_forget_to_end_it() -> None:
    """`SimpleQueue.get(timeout=…)` of Python 3.10 to 3.12: see day6_core/inbox.py."""
    for path, text in sources():
        assert "SimpleQueue" not in text or "get(timeout" not in text or path.name == "inbox.py", path


def _is_text(call: ast.Call) -> bool:
    """Whether a call opens a text file or a text pipe."""
    function = call.func
    owner = function.value if isinstance(function, ast.Attribute) else None
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    if name in ("read_text", "write_text"):
        # Those of Path; `files.BuildOutput` always writes UTF-8, and importlib.metadata reads it.
        return owner is not None and ast.unparse(owner).rpartition(".")[2] not in ("output", "metadata")
    if isinstance(owner, ast.Name) and owner.id == "subprocess":
        return any(each.arg in ("text", "universal_newlines") for each in call.keywords)
    if name == "fdopen" or (name == "open" and owner is None):
        modes = [*call.args[1:2], *(each.value for each in call.keywords if each.arg == "mode")]
        return not any(isinstance(mode, ast.Constant) and "b" in str(mode.value) for mode in modes)
    return False


@pytest.mark.parametrize("given", [{}, {"XDG_RUNTIME_DIR": "{}"}, {"DAY6_RUNTIME_DIR": "{}"}])
def test_a_students_program_looks_for_the_link_where_the_desktop_is(
    given: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from day6_core.link.paths import runtime_folders

    for name in ("XDG_RUNTIME_DIR", "DAY6_RUNTIME_DIR"):
        monkeypatch.delenv(name, raising=False)
    for name, value in given.items():
        monkeypatch.setenv(name, value.format(tmp_path))
    ours = runtime_folders()[0]
    environment = Desk(tmp_path / "home", join_link=False).environment()
    for name in list(os.environ):
        monkeypatch.delenv(name)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert runtime_folders()[0] == ours


def test_the_main_thread_never_waits_so_long_that_windows_would_miss_ctrl_c(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("day6_core.session.scheduler.LONGEST_WAIT", 0.001)
    looks: list[int] = []

    def until() -> bool:
        looks.append(len(looks))
        return len(looks) > 3

    assert Scheduler(WorldClock()).run(until, timeout=10.0), "it waited although nothing can happen"


def test_signals_have_linuxs_numbers_in_the_terminal_and_the_systems_below(monkeypatch: pytest.MonkeyPatch) -> None:
    here = [number for name, number in signals.NUMBERS.items() if hasattr(signals.signal, f"SIG{name}")]
    assert [signals.from_system(signals.to_system(number)) for number in here] == here
    monkeypatch.setattr(signals.signal, "SIGUSR1", 30, raising=False)  # macOS
    assert signals.to_system(10) == 30
    assert signals.to_system(64) == 64
    assert signals.from_system(200) == 200


def test_the_commands_on_a_windows_path_hold_no_path_of_this_machine() -> None:
    """A batch file is read in the old code page, in which a user's Chinese folder cannot be written."""
    texts = executables.texts("nt")
    assert texts["ros2.bat"] == '@"%DAY6_PYTHON%" -m day6_tui.main ros2 %*\r\n'
    assert not any(os.path.dirname(sys.executable) in text for text in texts.values())


def test_scripts_of_a_linux_machine_are_known_below_a_drive_of_windows() -> None:
    """`source /opt/ros/jazzy/setup.bash` is what everything begins with."""
    path = PureWindowsPath(r"C:\opt\ros\jazzy\setup.bash")
    assert as_on_linux(path) == as_on_linux(PurePosixPath("/opt/ros/jazzy/setup.bash")) == "/opt/ros/jazzy/setup.bash"
    sourced: Any = source_setup
    assert sourced(path, {})["ROS_DISTRO"] == "jazzy"


@pytest.mark.parametrize(
    ("name", "path", "folders"),
    [
        ("C:\\a b\\ws/src/", ntpath, ["C:\\a b", "C:\\a b\\ws", "C:\\a b\\ws/src/"]),
        ("ws/src", ntpath, ["ws", "ws/src"]),
        ("/a/b", posixpath, ["/a", "/a/b"]),
        ("./a", posixpath, ["./a"]),
    ],
)
def test_the_folders_above_one_end_at_the_root(name: str, path: Any, folders: list[str]) -> None:
    """`mkdir -p` of a path with a drive went up for ever."""
    assert folders_of(name, path) == folders


def test_socket_paths_are_measured_in_bytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from day6_core.link.paths import LONGEST_SOCKET_PATH, meeting_place

    if sys.platform == "win32":
        pytest.skip("no Unix sockets there")
    wanted = Path("/tmp", "学" * 24)
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(wanted))
    monkeypatch.delenv("DAY6_LINK", raising=False)
    made = meeting_place(7)
    shutil.rmtree(made.folder.parent)
    assert len(os.fsencode(made.own_socket("0123456789abcdef"))) + len(".lock") <= LONGEST_SOCKET_PATH
    assert not wanted.exists()
