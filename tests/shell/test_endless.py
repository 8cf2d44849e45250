"""What never ends in a terminal: Ctrl-C ends it, others go on meanwhile, and memory has an end before the machine's."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.waiting import communicate

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the signals and devices of Unix")

ENDLESS = {
    "commands that end at once": "while true; do :; done",
    "conditions": "until false; do true; done",
    "assignments": "for ((;;)); do x=1; done",
    "numbers": "seq 99999999999 > /dev/null",
    "a wait": "sleep infinity",
    "a device": "cat /dev/zero > /dev/null",
    "a device that is counted": "wc /dev/zero",
    "a tree of functions": "f() { f | f; } 2> /dev/null; f 2> /dev/null",
    "a device on standard input": "tr a b < /dev/zero > /dev/null",
}
BOUNDED = {
    "sort /dev/zero": (2, "sort: memory exhausted"),
    "PATH= diff /dev/zero /dev/zero": (2, "diff: /dev/zero: Cannot allocate memory"),
    "x=a; while true; do x=$x$x; done": (2, "bash: xrealloc: cannot allocate"),
    "mkfifo=$(python3 -c 'import os; os.mkfifo(\"f\")'); cat f": (1, "cat: f: Resource temporarily unavailable"),
    "source brackets": (2, "bash: memory exhausted"),
    "source braces": (2, "bash: memory exhausted"),
    'eval "$(cat conditions)"': (2, "bash: memory exhausted"),
    "echo " + "{a,b}" * 24: (1, "bash: brace expansion: cannot allocate memory"),
    "echo {1..99}{1..99}{1..99}{1..99}": (1, "bash: brace expansion: cannot allocate memory"),
    "printf %9999999999d 1": (1, "bash: printf: write error: Cannot allocate memory"),
    "printf %.9999999999f 1": (1, "bash: printf: write error: Cannot allocate memory"),
    'ros2 topic pub -1 /t std_msgs/msg/String "$(cat brackets)$(cat brackets)"': (
        126,
        "bash: /opt/ros/jazzy/bin/ros2: Argument list too long",
    ),
}
DEEP = {"brackets": "$(" * 50_000, "braces": "{ " * 50_000, "conditions": "[[ " + "! " * 50_000 + "a ]]"}


def start(line: str, folder: Path) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "day6_tui.main", "exec", "--home", str(folder / "home"), "-c", line],
        cwd=folder,
        env={**os.environ, "DAY6_LINK": "off"},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        encoding="utf-8",
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )


@pytest.mark.process
@pytest.mark.parametrize("what", ENDLESS)
def test_ctrl_c_ends_what_never_ends(what: str, tmp_path: Path) -> None:
    process = start(f"echo begun; {ENDLESS[what]}", tmp_path)
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    process.send_signal(signal.SIGINT)
    try:
        _, error = communicate(process)
    finally:
        process.kill()
    assert (process.returncode, error.strip()) == (130, "")


@pytest.mark.process
@pytest.mark.parametrize("line", BOUNDED)
def test_what_would_take_all_memory_or_wait_for_ever_ends_with_a_message(line: str, tmp_path: Path) -> None:
    for name, text in DEEP.items():
        (tmp_path / name).write_text(text)
    process = start(line, tmp_path)
    try:
        _, error = communicate(process)
    finally:
        process.kill()
    status, message = BOUNDED[line]
    assert (process.returncode, error.splitlines()[0][: len(message)]) == (status, message)


@pytest.mark.process
@pytest.mark.parametrize(
    "commands",
    [
        "cat /dev/zero > /dev/null & wc /dev/zero & seq 9999999999 > /dev/null &",
        "seq 9999999999 > file &",
        "seq 9999999999 | wc -l > file &",
        "seq 9999999999 | tail -n 1 | cat > file &",
        "wc /dev/zero | cat &",
        "tr a b < /dev/zero | wc -c > file &",
        "seq 9999999999 | tee file > /dev/null &",
        "cat /dev/zero > file &",
    ],
)
def test_others_go_on_beside_a_command_that_never_waits(commands: str, tmp_path: Path) -> None:
    process = start(f"{commands} sleep 0.1; echo on; kill $(jobs -p)", tmp_path)
    try:
        said, _ = communicate(process)
    finally:
        process.kill()
    assert (process.returncode, said) == (0, "on\n")


LETTERS = "a" * 40
EXPRESSIONS = {
    f"echo {LETTERS}b | grep -E '(a+)+$'": (1, ""),
    f"echo {LETTERS}b | grep -oE '(a|a)*b'": (0, LETTERS + "b"),
    f"echo {LETTERS}b | sed -E 's/(a|aa)+$/x/; s/(a*)*b/[&]/'": (0, f"[{LETTERS}b]"),
    f"[[ {LETTERS}b =~ ^(a+)+$ ]]": (1, ""),
    f"echo {LETTERS}b | PATH= grep -E '(a+)+\\1c'": (2, "grep: regular expression would take too long"),
    "PATH= grep -E \"$(printf '(%.0s' {1..9999})\" /dev/null": (2, "grep: Regular expression too big"),
}


@pytest.mark.process
@pytest.mark.parametrize("line", EXPRESSIONS)
def test_no_regular_expression_stops_everything(line: str, tmp_path: Path) -> None:
    process = start(f"{line} 2>&1", tmp_path)
    try:
        said, _ = communicate(process)
    finally:
        process.kill()
    status, shown = EXPRESSIONS[line]
    assert (process.returncode, said.strip()[: len(shown)]) == (status, shown)


@pytest.mark.process
def test_others_go_on_and_ctrl_c_works_beside_a_long_search(tmp_path: Path) -> None:
    (tmp_path / "long.txt").write_text("ab" * 500_000)
    process = start("(for i in 1 2 3; do sleep 0.01; echo tick; done) & PATH= grep -E '((a|b)+)+c' long.txt", tmp_path)
    try:
        assert process.stdout is not None
        assert [process.stdout.readline() for _ in range(3)] == ["tick\n"] * 3
        assert process.poll() is None  # it still searches
        process.send_signal(signal.SIGINT)
        communicate(process)
    finally:
        process.kill()
    assert process.returncode == 130


WAITING = {
    "cat f": 1,
    "echo x > f": 1,
    "cat < f": 1,
    "source f": 1,
    "bash f": 127,
    "bash /dev/zero": 127,
    "check_urdf f": 255,
    "check_urdf /dev/zero": 255,
    "urdf_to_graphviz f": 255,
    "ros2 bag info f": 1,
    "ros2 run demo_nodes_py talker --ros-args --params-file f": 1,
    "ros2 run demo_nodes_py talker --ros-args --params-file /dev/zero": 1,
    "ros2 run day6_world world --ros-args -p world:=f": 1,
    "ros2 run robot_state_publisher robot_state_publisher f": 250,
    "colcon build": 0,
    "timeout 1 rviz2 -d f": 124,
}


@pytest.mark.process
@pytest.mark.parametrize("line", WAITING)
def test_a_pipe_without_a_writer_and_a_device_without_end_keep_nobody_waiting(line: str, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "f")
    (tmp_path / "src" / "p").mkdir(parents=True)
    os.mkfifo(tmp_path / "src" / "p" / "package.xml")
    process = start(f"{line} 2>&1", tmp_path)
    try:
        said, _ = communicate(process)
    finally:
        process.kill()
    assert process.returncode == WAITING[line], said
    assert "Traceback" not in said


@pytest.mark.process
def test_the_streams_have_their_names_as_files(tmp_path: Path) -> None:
    process = start("echo a > /dev/stdout; echo b > /dev/stderr; echo c | cat /dev/stdin; echo d > /dev/tty", tmp_path)
    try:
        said, errors = communicate(process)
    finally:
        process.kill()
    assert said == "a\nc\n"
    assert errors == "b\nbash: /dev/tty: No such device or address\n"


@pytest.mark.process
def test_a_pipe_with_a_reader_is_written_to(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "f")
    line = "until echo x > f 2> /dev/null; do sleep 0.1; done"  # there is no reader at first
    process = start(f"python3 -c \"print(open('f').read(), end='')\" & {line}; wait", tmp_path)
    try:
        said, _ = communicate(process)
    finally:
        process.kill()
    assert said == "x\n"


@pytest.mark.process
def test_others_go_on_and_ctrl_c_works_beside_a_message_of_megabytes(tmp_path: Path) -> None:
    (tmp_path / "big.yaml").write_text("{data: [" + ",".join(map(str, range(500_000))) + "]}")
    ticks = 20
    process = start(
        f"(for ((i = 0; i < {ticks}; i++)); do sleep 0.1; echo tick; done) & "
        "ros2 topic pub --stdin -1 -w 0 /t std_msgs/msg/Int32MultiArray < big.yaml; echo over",
        tmp_path,
    )
    try:
        assert process.stdout is not None
        assert [process.stdout.readline() for _ in range(ticks)] == ["tick\n"] * ticks
        process.send_signal(signal.SIGINT)
        communicate(process)
    finally:
        process.kill()


@pytest.mark.process
@pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="needs folders without number: /proc of Linux")
def test_others_go_on_and_ctrl_c_works_beside_a_pattern_that_finds_half_the_disk(tmp_path: Path) -> None:
    process = start("(for i in 1 2 3; do sleep 0.1; echo tick; done) & : /proc/*/task/*/*/*/*/* /*/*/*/*/*", tmp_path)
    try:
        assert process.stdout is not None
        assert [process.stdout.readline() for _ in range(3)] == ["tick\n"] * 3
        process.send_signal(signal.SIGINT)
        communicate(process)
    finally:
        process.kill()
    assert process.returncode in (130, -signal.SIGINT)
