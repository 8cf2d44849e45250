"""Output that cannot be written: the command says so in the real tool's words, and its status is not 0."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

FULL = "/dev/full"
NO_SPACE = "No space left on device"

pytestmark = pytest.mark.skipif(os.name != "posix" or not os.path.exists(FULL), reason="/dev/full is Linux's")

MAIN = [sys.executable, "-m", "day6_tui.main"]

COMMANDS = [
    # (command line, what it says, its status): of bash 5.2 and coreutils 9.7, grep 3.11, sed 4.9, diffutils 3.10
    ("echo hi > /dev/full", "bash: echo: write error: {}", 1),
    ("echo hi >> /dev/full", "bash: echo: write error: {}", 1),
    ("printf hi > /dev/full", "bash: printf: write error: {}", 1),
    ("pwd > /dev/full", "bash: pwd: write error: {}", 1),
    ("type cd > /dev/full", "bash: type: write error: {}", 1),
    ("cat f > /dev/full", "cat: write error: {}", 1),
    ("ls > /dev/full", "ls: write error: {}", 2),
    ("head f > /dev/full", "head: write error: {}", 1),
    ("wc f > /dev/full", "wc: write error", 1),
    ("sort f > /dev/full", "sort: fflush failed: 'standard output': {}\nsort: write error", 2),
    ("grep a f > /dev/full", "grep: write error: {}", 2),
    ("sed s/a/b/ f > /dev/full", "sed: couldn't flush stdout: {}", 4),
    ("diff f /dev/null > /dev/full", "diff: standard output: {}", 2),
    ("find . > /dev/full", "find: ‘standard output’: {}\nfind: write error", 1),
    ("env > /dev/full", "env: write error: {}", 125),
    ("seq 3 > /dev/full", "seq: write error: {}", 1),
    ("true > /dev/full", "", 0),
    ("echo a | cat > /dev/full", "cat: write error: {}", 1),
    ("cat <<X > /dev/full\nhello\nX", "cat: write error: {}", 1),
    ("{ echo a; echo b; } > /dev/full", "bash: echo: write error: {}\nbash: echo: write error: {}", 1),
    ("( echo a ) > /dev/full", "bash: echo: write error: {}", 1),
    ("f() { echo a; }; f > /dev/full", "bash: echo: write error: {}", 1),
    ("for i in 1 2; do echo $i; done > /dev/full", "bash: echo: write error: {}\nbash: echo: write error: {}", 1),
    ("echo hi > /dev/full & wait $!", "bash: echo: write error: {}", 1),
    ("echo a > /dev/full || (exit 7)", "bash: echo: write error: {}", 7),
    ("set -e; echo a > /dev/full; echo never", "bash: echo: write error: {}", 1),
    ("echo $(echo hi > /dev/full; echo $?)", "bash: echo: write error: {}", 0),
    ("ls nope 2> /dev/full", "", 2),
    ("echo hi > /dev/full 2>&1", "", 1),
    ("echo x | tee /dev/full", "tee: /dev/full: {}", 1),
    ("echo x | tee f2 > /dev/full", "tee: 'standard output': {}", 1),
]


@pytest.mark.parametrize(("line", "says", "status"), COMMANDS, ids=[line for line, _, _ in COMMANDS])
def test_what_cannot_be_written_is_told_and_makes_the_status(
    machine: Any, tmp_path: Path, line: str, says: str, status: int
) -> None:
    (tmp_path / "f").write_text("b\na\n")
    result = machine.run(f"cd '{tmp_path}'\n{line}")
    assert result.err.rstrip("\n") == says.format(*[NO_SPACE] * 2)
    assert result.status == status


@pytest.mark.process
@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")
@pytest.mark.parametrize("line", [line for line, _, _ in COMMANDS])
def test_real_bash_ends_with_the_same_status(machine: Any, tmp_path: Path, line: str) -> None:
    (tmp_path / "f").write_text("b\na\n")
    real = subprocess.run(["bash", "-c", line], cwd=tmp_path, capture_output=True, check=False)
    assert machine.run(f"cd '{tmp_path}'\n{line}").status == real.returncode


def test_a_failed_write_leaves_no_traceback_and_the_next_command_works(machine: Any, caplog: Any) -> None:
    result = machine.run("echo lost > /dev/full; echo and on")
    assert (result.out, result.status) == ("and on\n", 0)
    assert not caplog.records


def test_the_ros2_command_ends_as_a_python_program_whose_output_is_lost(machine: Any) -> None:
    result = machine.run("ros2 pkg list > /dev/full")
    assert (result.status, result.err.splitlines()[-1]) == (120, f"OSError: [Errno 28] {NO_SPACE}")


@pytest.mark.process
def test_a_program_of_python_has_the_file_itself_and_its_own_words(machine: Any) -> None:
    result = machine.run("python3 -c 'print(1)' > /dev/full")
    assert result.status in (1, 120) and NO_SPACE in result.err


@pytest.mark.process
def test_as_much_as_fits_is_in_the_file(tmp_path: Path) -> None:
    """A limit of the size of files stops a normal user's program where a full disk stops everybody's."""
    resource = pytest.importorskip("resource")
    result = subprocess.run(
        [*MAIN, "exec", "-c", "seq 5000 > numbers; echo $?; echo on > small; cat small"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "XDG_DATA_HOME": str(tmp_path / "data")},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192)),
        capture_output=True,
        text=True,
        check=False,
    )
    assert (result.stdout, result.stderr) == ("1\non\n", "seq: write error: File too large\n")
    assert (tmp_path / "numbers").read_text() == "".join(f"{number}\n" for number in range(1, 5001))[:8192]


@pytest.mark.process
@pytest.mark.parametrize(
    ("line", "says", "status"),
    [
        ("echo a; echo b", "bash: echo: write error: {}\n" * 2, 1),
        ("ls; echo -n c", "ls: write error: {}\nbash: echo: write error: {}\n", 1),
    ],
)
def test_our_own_output_on_a_full_disk(tmp_path: Path, line: str, says: str, status: int) -> None:
    (tmp_path / "f").touch()
    env = {**os.environ, "XDG_DATA_HOME": str(tmp_path / "data")}
    with open(FULL, "w") as full:
        result = subprocess.run(
            [*MAIN, "exec", "-c", line],
            cwd=tmp_path,
            env=env,
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert (result.stderr, result.returncode) == (says.format(*[NO_SPACE] * 2), status)


LOGGER = """
import rclpy
rclpy.init()
node = rclpy.create_node('a')
for number in range(100):
    node.get_logger().info('x' * 1000)
print('alive')
"""


@pytest.mark.process
def test_a_program_that_logs_to_a_full_disk_goes_on(machine: Any, tmp_path: Path) -> None:
    (tmp_path / "logger.py").write_text(LOGGER)
    result = machine.run(f"cd '{tmp_path}'; DAY6_LINK=off python3 logger.py 2> /dev/full")
    assert (result.out, result.status) == ("alive\n", 0)


def test_a_node_of_ours_that_logs_to_a_full_disk_goes_on(machine: Any) -> None:
    lines = "timeout 0.5 ros2 run turtlesim turtlesim_node {}; echo $?"
    for where in ("2> /dev/full", "> /dev/full 2>&1"):
        result = machine.run(lines.format(where), seconds=1.0)
        assert (result.out, result.err) == ("124\n", "")


def test_a_log_file_that_cannot_be_written_ends_nothing(machine: Any, tmp_path: Path) -> None:
    (tmp_path / "log").write_text("a file, not a folder")
    line = f"ROS_LOG_DIR='{tmp_path}/log' timeout 0.5 ros2 run turtlesim turtlesim_node; echo $?"
    assert machine.run(line, seconds=1.0).out == "124\n"
