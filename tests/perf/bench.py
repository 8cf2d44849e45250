"""Measures the budgets of day6-tui and prints one table.

    python -m tests.perf.bench [--real PYTHON] [--real-ros2 COMMAND] [--beside PYTHON] [--only SECTION …] [--quick]

`--real` is an interpreter with real rclpy, `--real-ros2` the real command with its daemon running: what can be measured on both
is, in turns, and the ratio is printed. `--beside` is another installation of day6-tui, whose desktop then runs some scenes at the
same time. Everything is compared within one run, because machines differ. Status 1 if something is over its budget
(`budgets.py`). Linux only.
"""

from __future__ import annotations

import argparse
import contextlib
import itertools
import json
import os
import shlex
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from day6_core.ros.environment import program_environment
from day6_core.shell.screen.screen import Screen as Picture
from tests.perf import budgets
from tests.perf.budgets import Budget, Row, figure, print_table
from tests.perf.load import DENSE, PUBLISH, SCENES, TURTLE, measure
from tests.perf.screen import Screen, rss_mb
from tests.perf.slow_line import slow_lines

HERE = Path(__file__).resolve().parent
DAY6 = [sys.executable, "-m", "day6_tui.main"]
BARE = [sys.executable, str(HERE / "bare_app.py")]

RUNAWAYS = {
    "loop.py": "while True: pass\n",
    "print.py": "while True: print('again and again')\n",
    "sum.py": "n = 0\nwhile True: n += sum(range(1000))\n",
}

FLOODS = {
    "lines": ("for n in range(250_000): print('%079d' % n)", 20_000_000, budgets.LINES),
    "single": ("print('x' * 5_000_000)", 5_000_000, budgets.ONE_LINE),
    "chinese": ("for n in range(100_000): print('机器人操作系统' * 4, n)", 9_000_000, budgets.CHINESE),
    "coloured": (
        "for n in range(100_000): print(f'\\x1b[33m[WARN] [{n}.123456789] [talker]: Publishing: Hello {n}\\x1b[0m')",
        7_000_000,
        budgets.COLOURED,
    ),
    "binary": (
        "import random, sys\nsys.stdout.buffer.write(random.Random(1).randbytes(4_000_000))",
        4_000_000,
        budgets.BINARY,
    ),
}
"""Programs, how many bytes they print, and the budget."""

SCENE_CPU = {
    "welcome": budgets.WELCOME,
    "standing": budgets.STANDING,
    "dense": budgets.DRIVING,
    "four": budgets.FOUR_STANDING,
    "panes": budgets.FOUR_DRIVING,
    "turning": budgets.TURNING,
    "world": budgets.WORLD_STANDING,
    "circles": budgets.WORLD_DRIVING,
    "lidar": budgets.LIDAR,
}
"""Scenes of `load.py`."""
COMPARED = ("turning", "lidar", "panes")
"""Those that `--beside` compares."""

# Compiled modules are part of any installation; a machine that forbids writing them would measure the compiler.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)


PIXEL_ANSWERS = {
    "kitty": {b"\x1b[>0q": b"\x1bP>|kitty\x1b\\", b"a=q": b"\x1b_Gi=31;OK\x1b\\"},
    "sixel": {b"\x1b[>0q": b"\x1bP>|XTerm\x1b\\"},
}
"""What the two kinds of terminals answer to what is asked of them, and what both do."""
BOTH_ANSWER = {b"\x1b[16t": b"\x1b[6;20;10t", b"\x1b[c": b"\x1b[?62;4c", b"\x1b[5n": b"\x1b[0n"}


class PixelScreen(Screen):
    """A terminal that shows real pixels: it answers, and is ready as soon as it has read a picture."""

    answers: dict[bytes, bytes] = {}

    def read(self, seconds: float) -> int:
        deadline, before = time.perf_counter() + seconds, len(self.output)
        while (left := deadline - time.perf_counter()) > 0:
            seen = len(self.output)
            if super().read(min(left, 0.01)):
                new = self.output[max(0, seen - 8) :]
                due = [
                    (place, reply)
                    for question, reply in self.answers.items()
                    if (place := new.rfind(question)) >= 0 and place + len(question) > min(8, seen)
                ]
                os.write(self._fd, b"".join(reply for _, reply in sorted(due)))
        return len(self.output) - before

    @property
    def pictures(self) -> int:
        """Pictures written so far."""
        return self.output.count(b"\x1b[5n")


class Bench:
    """One run: `quick` measures shorter and fewer times."""

    def __init__(self, quick: bool) -> None:
        self.rounds = 3 if quick else 7
        self.seconds = 3.0 if quick else 8.0
        self.home = Path(tempfile.mkdtemp(prefix="day6-bench-"))
        self.env = {
            "DAY6_RUNTIME_DIR": tempfile.mkdtemp(prefix="day6-bench-"),
            "LANG": "C.UTF-8",
        }

    def desktop(self, columns: int, rows: int, *options: str, cpus: set[int] | None = None) -> Screen:
        command = [*DAY6, "--home", str(self.home), "--lang", "en", *options]
        return Screen(command, columns, rows, cpus, **self.env)

    def start(self) -> Iterator[Row]:
        """First frame and memory, beside a bare Textual app."""
        ours, bare, memory = [], [], []
        for _ in range(self.rounds):
            with Screen(BARE, 80, 24) as screen:
                bare.append(screen.first_frame())
            with self.desktop(80, 24) as screen:
                ours.append(screen.first_frame())
                memory.append(screen.rss_mb())
        seconds = statistics.median(ours)
        yield budgets.FIRST_FRAME.row(seconds / statistics.median(bare), f"{seconds:.2f} s")
        yield budgets.FIRST_MEMORY.row(statistics.median(memory))

    def scenes(self, beside: str | None) -> Iterator[Row]:
        """CPU and memory of the running desktop; of some beside another installation at the same time."""
        for name, budget in SCENE_CPU.items():
            others = [beside] if beside and name in COMPARED else []
            *before, ours = measure(SCENES[name], [*others, sys.executable], self.seconds)
            yield budget.row(ours.cpu, f"{ours.bytes:.0f} bytes a second")
            if name == "dense":
                yield budgets.FRAME.row(ours.bytes / 30)
            if name in ("turning", "lidar"):
                yield Row("  memory", f"{ours.pss:.1f} MB (RSS {ours.rss:.1f} MB)")
            for other in before:
                yield budgets.BESIDE.row(
                    ours.cpu / other.cpu,
                    f"{name}: {ours.cpu:.2f} instead of {other.cpu:.2f} %, {ours.bytes:.0f} bytes a second of {other.bytes:.0f}",
                )
        (car,) = measure(SCENES["car"], [sys.executable], self.seconds)
        yield budgets.ROBOT_MEMORY.row(car.pss, f"RSS {car.rss:.1f} MB")
        yield Row("CPU, car with turning wheels", f"{car.cpu:.1f} %")

    def pixels(self) -> Iterator[Row]:
        """A turtle in circles over a dense drawing, in a window of 480 x 480 real pixels, which is as many as 600 x 400."""
        for kind, answers in PIXEL_ANSWERS.items():
            command = [*DAY6, "--home", str(self.home), "--lang", "en", "--scene", "empty"]
            with PixelScreen(command, 104, 28, **self.env) as screen:
                screen.answers = {**answers, **BOTH_ANSWER}
                screen.read(4)
                screen.send(TURTLE)
                screen.read(3)
                screen.send(DENSE + "\n")
                screen.read(8)
                screen.send(PUBLISH + "\n")
                screen.read(4)
                before = screen.pictures
                usage = screen.use(self.seconds)
                pictures = screen.pictures - before
                yield budgets.PIXELS.row(usage.cpu_percent, f"{kind}, {pictures / usage.seconds:.0f} fps")
                yield budgets.PIXEL_FRAME.row(usage.bytes_written / max(1, pictures) / 1e3)

    def floods(self) -> Iterator[Row]:
        """A program that prints a lot, from Enter to what follows it, beside a bare reader of the same program's pty.

        The time an empty program takes is left out of both.
        """
        for name, (code, _, _) in FLOODS.items():
            (self.home / f"{name}.py").write_text(code + "\n", encoding="utf-8")
        (self.home / "nothing.py").touch()
        with self.desktop(120, 40, "--scene", "empty") as screen:
            screen.first_frame()
            screen.read(2)
            for name, (_, size, budget) in FLOODS.items():
                bare = _bare_flood(self.home / f"{name}.py")
                began, cpu = time.perf_counter(), screen._cpu_seconds()
                screen.output.clear()
                # The quotes keep the echo of the line from being taken for what it prints.
                screen.send(f"clear; python3 {name}.py; echo 'DO'NE{name}\r")
                mark = f"DONE{name}".encode()
                screen.wait_for(lambda output, mark=mark: mark in output, 120.0)
                seconds = time.perf_counter() - began
                cpu = screen._cpu_seconds() - cpu
                bare = statistics.mean((bare, _bare_flood(self.home / f"{name}.py")))
                start = _bare_flood(self.home / "nothing.py")
                seconds, bare = max(seconds - start, 1e-3), max(bare - start, 1e-3)
                rate, share = size / seconds / 1e6, bare / seconds
                yield budget.row(
                    share if budget is budgets.ONE_LINE else rate,
                    f"{rate:.1f} MB/s = {share:.2f} × a bare reader, {cpu / size * 1e6:.3f} CPU s/MB, "
                    f"load {os.getloadavg()[0]:.1f}",
                )

    def reflow(self) -> Iterator[Row]:
        """A full scrollback, every row of which becomes two of another width."""
        coloured = "\x1b[33m[WARN]\x1b[0m Publishing " + "Hello"
        lines = {
            "plain": "word " * 15 + "words",
            "Chinese": "机器人操作" * 8,
            "coloured": coloured + " Hello" * 9 + "!",
            "coloured Chinese": coloured + "机器人操作系统" * 4,
        }
        for name, line in lines.items():
            picture = Picture(80, 24)
            picture.feed(f"{line}\r\n" * 5_100)
            rows, seconds = 0, []
            for columns in (40, 80, 41, 79):
                began = time.perf_counter()
                picture.resize(24, columns)
                seconds.append(time.perf_counter() - began)
                rows = max(rows, len(picture.scrollback))
            yield budgets.REFLOW.row(1e3 * max(seconds), f"{name} lines, {rows} rows")

    def keys(self) -> Iterator[Row]:
        """Key to echo, alone and with three runaway student programs, all on one core."""
        for name, code in RUNAWAYS.items():
            (self.home / name).write_text(code, encoding="utf-8")
        one_core = {min(os.sched_getaffinity(0))}
        with self.desktop(120, 40, "--scene", "empty", cpus=one_core) as screen:
            screen.first_frame()
            screen.read(3)
            yield Row("key to echo, alone", _spread(_echoes(screen, self.rounds * 4)))
            for name in RUNAWAYS:
                screen.send(f"python3 {name} > /dev/null &\n")
                screen.read(1)
            screen.read(2)
            seconds = _echoes(screen, self.rounds * 4)
            yield budgets.ECHO.row(statistics.median(seconds) * 1e3)
            yield budgets.ECHO_WORST.row(max(seconds) * 1e3)
        with self.desktop(120, 40, "--scene", "turtle", cpus=one_core) as screen:
            screen.first_frame()
            screen.read(10)
            screen.send("\x1bOQ")  # F2
            screen.read(1)
            yield Row("key to echo, beside turtle, node, teleop and echo", _spread(_echoes(screen, self.rounds * 4)))

    def paste(self) -> Iterator[Row]:
        """A megabyte pasted at the prompt: when its end is on the screen, and what it does to turtlesim meanwhile."""
        (self.home / "poses.py").write_text(POSES, encoding="utf-8")
        with self.desktop(120, 40, "--scene", "empty") as screen:
            screen.first_frame()
            screen.read(2)
            screen.send(TURTLE)
            screen.read(2)
            screen.send("python3 poses.py &\n")
            screen.read(3)
            screen.output.clear()
            pasted = time.time()
            began = time.perf_counter()
            screen.paste(": '" + "x" * 1_000_000 + "ENDOFPASTE")
            screen.wait_for(lambda output: b"ENDOFPASTE" in output, 60.0)
            seconds = time.perf_counter() - began
            screen.read(2)
            screen.send("\x03")
            screen.read(1)
        times = [float(line) for line in (self.home / "poses.txt").read_text(encoding="utf-8").splitlines()]
        times = [each for each in times if pasted <= each <= pasted + max(seconds, 1.0)]
        gaps = [after - before for before, after in itertools.pairwise(times)]
        yield budgets.PASTE.row(
            seconds,
            f"turtlesim's 62.5 poses a second meanwhile: {1 / statistics.mean(gaps):.1f}, "
            f"at most {max(gaps) * 1000:.0f} ms apart",
        )


POSES = """
import time
import rclpy
from turtlesim.msg import Pose
rclpy.init()
node = rclpy.create_node('bench_poses')
out = open('poses.txt', 'w', buffering=1)
node.create_subscription(Pose, 'turtle1/pose', lambda pose: print(time.time(), file=out), 100)
rclpy.spin(node)
"""
"""Writes down when each pose of the turtle comes."""


def _bare_flood(program: Path) -> float:
    """The seconds until a reader that only throws it away has all that a program prints on its pty."""
    master, slave = os.openpty()
    began = time.perf_counter()
    process = subprocess.Popen(["nice", sys.executable, str(program)], stdin=slave, stdout=slave, stderr=slave)
    os.close(slave)
    with contextlib.suppress(OSError):  # Linux: the last process left the pty
        while os.read(master, 65536):
            pass
    process.wait()
    os.close(master)
    return time.perf_counter() - began


def _echoes(screen: Screen, count: int) -> list[float]:
    return [screen.echo_time(key) for key in ("xyzw" * count)[:count]]


def _spread(seconds: list[float]) -> str:
    return f"{statistics.median(seconds) * 1000:.0f} ms median, {max(seconds) * 1000:.0f} ms worst"


SIDE_BY_SIDE = {
    "publish_String": ("publish -> callback, String", 1e6, "µs"),
    "publish_Twist": ("publish -> callback, Twist", 1e6, "µs"),
    "publish_JointState": ("publish -> callback, JointState of 10", 1e6, "µs"),
    "fan_out_10": ("publish -> 10 callbacks, String", 1e6, "µs"),
    "fan_out_100": ("publish -> 100 callbacks, String", 1e6, "µs"),
    "service": ("service round trip", 1e6, "µs"),
    "action": ("action, goal to result", 1e6, "µs"),
    "hundred_nodes": ("100 nodes in one process", 1e3, "ms"),
    "hundred_nodes_memory": ("  their memory", 1 / 1024, "MB"),
}


def side_by_side(real: str | None, seconds: float, rounds: int = 3) -> Iterator[Row]:
    """One process by itself, on our rclpy and on a real one, in turns: the medians, and those with a budget compared."""
    ours_env = program_environment({**os.environ, "DAY6_LINK": "off"})
    sides: dict[str, list[dict[str, float]]] = {"ours": [], "real": []}
    for _ in range(rounds):
        sides["ours"].append(_measure_side(sys.executable, ours_env, seconds))
        if real:
            sides["real"].append(_measure_side(real, dict(os.environ), seconds))
    mine, theirs = (
        {name: statistics.median(each[name] for each in side) for name in SIDE_BY_SIDE} if side else {}
        for side in sides.values()
    )
    for name, (what, scale, unit) in SIDE_BY_SIDE.items():
        text = f"{figure(mine[name] * scale)} {unit}"
        if theirs:
            text += f" (real {figure(theirs[name] * scale)} {unit}) = {theirs[name] / mine[name]:.1f} × better"
        yield Row(what, text)
    if theirs:
        yield budgets.ACTION.row(theirs["action"] / mine["action"])


def _measure_side(python: str, env: dict[str, str], seconds: float) -> dict[str, float]:
    command = [python, str(HERE / "rclpy_side.py"), str(seconds)]
    done = subprocess.run(command, capture_output=True, text=True, env=env, check=True, encoding="utf-8")
    return json.loads(done.stdout)  # type: ignore[no-any-return]


def timers(real: str | None, seconds: float, rounds: int = 5) -> Iterator[Row]:
    """A timer of 100 Hz on both sides and a loop that only sleeps, at the same time: what the machine does meets all of them.

    Nothing that waits can be more exact than the sleep.
    """
    ours_env = program_environment({**os.environ, "DAY6_LINK": "off"})
    sides = {"day6-tui": (sys.executable, ours_env, "timer"), "time.sleep": (sys.executable, ours_env, "sleep")}
    if real:
        sides["real"] = (real, dict(os.environ), "timer")
    found: dict[str, list[list[float]]] = {name: [] for name in sides}
    for _ in range(rounds):
        running = {
            name: subprocess.Popen(
                [python, str(HERE / "rclpy_side.py"), str(seconds), what], stdout=subprocess.PIPE, text=True, env=env
            )
            for name, (python, env, what) in sides.items()
        }
        for name, process in running.items():
            found[name].append(json.loads(process.communicate()[0]))
    middle, most = (
        {name: statistics.median(each[at] for each in sets) for name, sets in found.items()} for at in (0, 1)
    )
    for what, figures in (("100 Hz timer misses its period by, median", middle), ("  99th percentile", most)):
        yield Row(what, ", ".join(f"{name} {figure(missed * 1e6)} µs" for name, missed in figures.items()))
    if real:
        yield budgets.TIMER.row(
            most["day6-tui"] / most["real"], f"a bare time.sleep {figure(most['time.sleep'] / most['real'])} ×"
        )


TALKER = """
import sys, time
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('bench_talker')
publisher = node.create_publisher(String, 'chatter', 10)
while True:
    publisher.publish(String(data=sys.argv[1]))
    time.sleep(0.002)
"""

LISTENER = """
import time
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('bench_listener')
heard = set()
def hear(message):
    if message.data not in heard:
        heard.add(message.data)
        print(message.data, time.time(), flush=True)
node.create_subscription(String, 'chatter', hear, 10)
print('ready', flush=True)
rclpy.spin(node)
"""


ALONE = """
import sys
import rclpy
rclpy.init()
node = rclpy.create_node('bench_alone')
print(next(int(line.split()[1]) for line in open('/proc/self/status') if line.startswith('VmRSS')), flush=True)
node.destroy_node()
rclpy.shutdown()
"""


def processes(real: str | None, rounds: int) -> Iterator[Row]:
    """A student's process: from its start until another one hears it, joined to the link; from start to end, alone."""
    joined = program_environment({**os.environ, "DAY6_RUNTIME_DIR": tempfile.mkdtemp(prefix="day6-bench-")})
    alone = program_environment({**os.environ, "DAY6_LINK": "off"})
    with contextlib.ExitStack() as running:
        ears = {
            python: running.enter_context(_Listener(python, env))
            for python, env in ((sys.executable, joined), (real, dict(os.environ)))
            if python
        }
        yield from _compared(
            lambda python: ears[python].hear(), real, rounds, budgets.FIRST_MESSAGE, budgets.JOINED_MEMORY
        )
    yield from _compared(
        lambda python: _whole_process(python, alone if python == sys.executable else dict(os.environ)),
        real,
        rounds,
        budgets.ALONE,
        budgets.ALONE_MEMORY,
    )


def _compared(
    measured: Callable[[str], tuple[float, float]], real: str | None, rounds: int, time: Budget, memory: Budget
) -> Iterator[Row]:
    """Seconds and MB of both sides, measured in turns."""
    ours, theirs = [], []
    for _ in range(rounds):
        ours.append(measured(sys.executable))
        if real:
            theirs.append(measured(real))
    seconds, size = _medians(ours)
    if theirs:
        seconds_of_real, size_of_real = _medians(theirs)
        yield time.row(seconds / seconds_of_real, f"{seconds * 1e3:.0f} instead of {seconds_of_real * 1e3:.0f} ms")
        yield memory.row(size, f"real {size_of_real:.1f} MB")
    else:
        yield Row(time.what.partition(": ")[0], f"{seconds * 1e3:.0f} ms")
        yield memory.row(size)


class _Listener:
    """A program that hears each talker's first message."""

    def __init__(self, python: str, env: dict[str, str]) -> None:
        self._python, self._env, self._talkers = python, env, 0
        self._process = subprocess.Popen([python, "-c", LISTENER], stdout=subprocess.PIPE, text=True, env=env)
        self._line()

    def __enter__(self) -> _Listener:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.wait()

    def hear(self) -> tuple[float, float]:
        """Start a talker; return the seconds until its first message is here, and its memory in MB."""
        self._talkers += 1
        began = time.time()
        talker = subprocess.Popen([self._python, "-c", TALKER, str(self._talkers)], env=self._env)
        try:
            name, heard = self._line().split()
            assert name == str(self._talkers)
            return float(heard) - began, rss_mb(talker.pid)
        finally:
            talker.kill()
            talker.wait()

    def _line(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline()


def _medians(pairs: list[tuple[float, float]]) -> tuple[float, float]:
    return statistics.median(each[0] for each in pairs), statistics.median(each[1] for each in pairs)


def _whole_process(python: str, env: dict[str, str]) -> tuple[float, float]:
    began = time.perf_counter()
    (rss,) = _words(python, ALONE, env)
    return time.perf_counter() - began, int(rss) / 1024


def _words(python: str, code: str, env: dict[str, str]) -> list[str]:
    done = subprocess.run([python, "-c", code], capture_output=True, text=True, env=env, check=True, encoding="utf-8")
    return done.stdout.split()


def topic_list(real: str | None, rounds: int) -> Iterator[Row]:
    """`ros2 topic list` in a terminal that is not ours, each time a process of its own."""
    env = {**os.environ, "DAY6_RUNTIME_DIR": tempfile.mkdtemp(prefix="day6-bench-")}
    command = [str(Path(sys.executable).with_name("day6-tui")), "ros2", "topic", "list"]
    ours, theirs = [], []
    for _ in range(rounds):
        ours.append(_seconds(command, env))
        if real:
            theirs.append(_seconds([*shlex.split(real), "topic", "list"], dict(os.environ)))
    yield budgets.TOPIC_LIST.row(statistics.median(ours))
    if theirs:
        yield budgets.TOPIC_LIST_REAL.row(statistics.median(ours) / statistics.median(theirs))


def _seconds(command: list[str], env: dict[str, str]) -> float:
    began = time.perf_counter()
    subprocess.run(command, env=env, check=True, capture_output=True)
    return time.perf_counter() - began


SECTIONS: dict[str, Callable[[Bench, argparse.Namespace], Iterator[Row]]] = {
    "start": lambda bench, _: bench.start(),
    "scenes": lambda bench, options: bench.scenes(options.beside),
    "pixels": lambda bench, _: bench.pixels(),
    "floods": lambda bench, _: bench.floods(),
    "reflow": lambda bench, _: bench.reflow(),
    "keys": lambda bench, _: bench.keys(),
    "slow-lines": lambda bench, _: slow_lines(),
    "paste": lambda bench, _: bench.paste(),
    "processes": lambda bench, options: processes(options.real, bench.rounds),
    "rclpy": lambda bench, options: side_by_side(options.real, bench.seconds / 4),
    "timers": lambda bench, options: timers(options.real, bench.seconds / 4),
    "ros2": lambda bench, options: topic_list(options.real_ros2, bench.rounds),
}


def main() -> int:
    """Run the sections and print the table as Markdown."""
    parser = argparse.ArgumentParser(
        description=__doc__,
        epilog=f"sections: {', '.join(SECTIONS)}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--real", metavar="PYTHON", help="interpreter with real rclpy")
    parser.add_argument("--real-ros2", metavar="COMMAND", help="the real ros2, with its daemon running")
    parser.add_argument("--beside", metavar="PYTHON", help="interpreter of another installation of day6-tui")
    parser.add_argument(
        "--only", nargs="+", choices=SECTIONS, default=list(SECTIONS), metavar="SECTION", help=", ".join(SECTIONS)
    )
    parser.add_argument("--quick", action="store_true", help="shorter and fewer measurements")
    options = parser.parse_args()
    bench = Bench(options.quick)
    return int(print_table(row for name in options.only for row in SECTIONS[name](bench, options)) > 0)


if __name__ == "__main__":
    sys.exit(main())
