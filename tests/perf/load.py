"""Measures what one desktop costs while somebody looks at it: CPU, wake-ups and bytes of each scene.

    python -m tests.perf.load [--beside PYTHON] [--scene NAME …] [--rounds N] [--seconds S] [--threads] [--desktops N]

`--beside` is the interpreter of another installation, for instance of the commit before. The scene then runs in both at the same
time, so that a noisy machine disturbs both alike, and the ratio is printed. CPU is the process's own time, user and system, as
the kernel's scheduler counts it. Linux only.
"""

from __future__ import annotations

import argparse
import itertools
import os
import select
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from day6_urdf.shipped import shipped_model
from tests.perf.screen import Screen

TURNTABLE_VIEW = """\
Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/Grid
      Name: Grid
    - Class: rviz_default_plugins/RobotModel
      Description Topic:
        Value: /robot_description
      Name: RobotModel
  Global Options:
    Fixed Frame: stand
  Views:
    Current:
      Class: rviz_default_plugins/Orbit
      Distance: 0.9
"""

CIRCLE = '"{linear: {x: 0.15}, angular: {z: 0.6}}"'
TURNING = "[left_wheel_joint, right_wheel_joint, turntable]"
TWIST = '"{linear: {x: 2.0}, angular: {z: 0.7}}"'
DENSE = "".join(
    f'ros2 service call /turtle1/teleport_absolute turtlesim/srv/TeleportAbsolute "{{x: {x}, y: {y}}}" > /dev/null; '
    for x, y in [(1, 1), (10, 10), (1, 10), (10, 1), (5, 10), (1, 4), (10, 7), (3, 1), (8, 10), (5, 5)]
)
TURTLE = "ros2 run turtlesim turtlesim_node &\n"


def publish(twist: str, topic: str = "/turtle1/cmd_vel", how: str = "-r 10") -> str:
    """A command line without its end that drives."""
    return f"ros2 topic pub {how} {topic} geometry_msgs/msg/Twist {twist} > /dev/null"


PUBLISH = publish(TWIST)
"""Ten commands a second to the turtle."""

COLUMNS, ROWS = 120, 40
REPEAT = 1 / 30
"""Seconds between two keys of a key that is held down."""

HELD = ["\x1b[A"] * 20 + ["\x1b[D"] * 6
"""Forward, a bit to the left, and again."""


def on_a_turntable() -> str:
    """The description of the shipped car with a stand below it that turns it about the vertical."""
    joint = (
        '<link name="stand"/><joint name="turntable" type="continuous"><parent link="stand"/><child link="base_link"/>'
        '<axis xyz="0 0 1"/></joint>'
    )
    return shipped_model().read_text(encoding="utf-8").replace("</robot>", f"{joint}</robot>")


@dataclass
class Scene:
    """How a scene is reached, and what is typed all the time while it is measured."""

    options: tuple[str, ...]
    prepare: Callable[[Screen], None]
    held: tuple[str, ...] = ()
    size: tuple[int, int] = (COLUMNS, ROWS)
    files: Mapping[str, str] = field(default_factory=dict)
    """What is in the home folder, by name."""


def _wait(seconds: float) -> Callable[[Screen], None]:
    return lambda screen: (screen.read(seconds), None)[1]


def _type(*steps: tuple[str, float]) -> Callable[[Screen], None]:
    """Type each text and give it so many seconds."""

    def prepare(screen: Screen) -> None:
        screen.read(1.5)
        for text, seconds in steps:
            screen.send(text)
            screen.read(seconds)

    return prepare


WORLD = ("ros2 launch day6_world world.launch.py world:=walls > /dev/null 2>&1 &\n", 5.0)
CIRCLES = (publish(CIRCLE, "/cmd_vel", "--once") + "\n", 4.0)

SCENES = {
    "welcome": Scene((), _wait(4), size=(80, 24)),
    "standing": Scene(("--scene", "empty"), _type((TURTLE, 4))),
    "driving": Scene(("--scene", "empty"), _type((TURTLE, 3), (PUBLISH + "\n", 12))),
    "dense": Scene(("--scene", "empty"), _type((TURTLE, 3), (DENSE + "\n", 8), (PUBLISH + "\n", 12))),
    "four": Scene(("--scene", "turtle"), _wait(11)),
    "held": Scene(("--scene", "turtle"), _wait(11), held=tuple(HELD)),
    "car": Scene(("--scene", "car"), _wait(14)),
    "rviz": Scene(
        ("--scene", "car"),
        _type(("", 13), ("\x1bOQ", 1), ("rviz2 > /dev/null 2>&1 &\n", 5)),
    ),
    "panes": Scene(("--scene", "turtle"), _type(("", 10), ("\x1bOQ", 1), (PUBLISH + "\n", 5))),
    "turning": Scene(
        ("--scene", "empty"),
        _type(
            ("ros2 run robot_state_publisher robot_state_publisher turntable.urdf > /dev/null 2>&1 &\n", 2),
            ("rviz2 -d turntable.rviz > /dev/null 2>&1 &\n", 5),
            ("\x1bOR\x1b[19~", 2),  # F3: the window, F8: enlarged
            ("\x1bOR", 1),
            (f"ros2 run day6_bot wheel_spinner --ros-args -p 'joints:={TURNING}' > /dev/null 2>&1 &\n", 2),
            ("\x1bOR", 3),
        ),
        files={"turntable.urdf": on_a_turntable(), "turntable.rviz": TURNTABLE_VIEW},
    ),
    "world": Scene(("--scene", "empty"), _type(WORLD)),
    "circles": Scene(("--scene", "empty"), _type(WORLD, CIRCLES)),
    "lidar": Scene(("--scene", "empty"), _type(WORLD, CIRCLES, ("\x1bORl", 2))),  # F3: the window, l: the lidar
}
"""welcome; turtle standing; driven by ten commands a second; the same over many lines; teleop and echo beside it, standing and
with an arrow held down; the car with turning wheels, and RViz beside it; the turtle's four panes while a program drives; a robot
that turns in an enlarged RViz; the world at 50 steps a second, standing, driving in circles, and with its lidar drawn."""

STILL = {
    **{f"ros2 run {name} {name}": name for name in (
        "rqt_action", "rqt_bag", "rqt_console", "rqt_graph", "rqt_image_view", "rqt_logger_level", "rqt_msg", "rqt_plot",
        "rqt_publisher", "rqt_py_console", "rqt_reconfigure", "rqt_robot_steering", "rqt_service_caller", "rqt_shell",
        "rqt_srv", "rqt_tf_tree", "rqt_topic", "joint_state_publisher_gui",
    )},
    "ros2 run turtlesim turtlesim_node": "turtlesim",
    "ros2 run day6_bot car_view": "car",
    "ros2 run day6_world world": "world",
    "ros2 run day6_kitchen kitchen": "kitchen",
    "ros2 run day6_inspector inspector": "inspector",
    "rviz2": "rviz2",
    "ros2 launch day6_bot display.launch.py": "rviz2 with a robot",
}  # fmt: skip
"""Windows in which nothing happens."""

SCENES.update(
    **{
        f"still: {name}": Scene(("--scene", "empty"), _type((f"{line} > /dev/null 2>&1 &\n", 12)))
        for line, name in STILL.items()
    },
    **{
        "still: terminal": Scene(("--scene", "empty"), _wait(4)),
        "still: editor": Scene(("--scene", "empty"), _type(("nano notes.py\n", 4), ("print()", 4))),
        "still: lesson": Scene(("--lesson", "day1"), _wait(12)),
    },
)


class Measured:
    """One desktop and its figures between two moments."""

    def __init__(self, python: str, scene: Scene) -> None:
        self.home = Path(tempfile.mkdtemp(prefix="day6-load-"))
        for name, text in scene.files.items():
            (self.home / name).write_text(text, encoding="utf-8")
        command = [str(Path(python).with_name("day6-tui")), "--home", str(self.home), "--lang", "en", *scene.options]
        env = {"DAY6_RUNTIME_DIR": tempfile.mkdtemp(prefix="day6-load-"), "LANG": "C.UTF-8"}
        self.screen = Screen(command, *scene.size, **env)

    def begin(self) -> None:
        self._cpu, self._switches, self._bytes = self.threads(), self._context_switches(), len(self.screen.output)
        self._began = time.perf_counter()

    def end(self) -> None:
        self.seconds = time.perf_counter() - self._began
        after = self.threads()
        self.by_thread = {
            name: 100 * (cpu - self._cpu.get(name, 0.0)) / self.seconds for name, cpu in sorted(after.items())
        }
        self.cpu = sum(self.by_thread.values())
        self.switches = (self._context_switches() - self._switches) / self.seconds
        self.bytes = (len(self.screen.output) - self._bytes) / self.seconds
        self.pss, self.rss = self.screen.pss_mb(), self.screen.rss_mb()

    def threads(self) -> dict[str, float]:
        """CPU seconds of each thread, by its name and number."""
        found = {}
        folder = Path(f"/proc/{self.screen.pid}/task")
        for task in folder.iterdir():
            name = (task / "comm").read_text().strip()
            found[f"{name} {task.name}"] = int((task / "schedstat").read_text().split()[0]) / 1e9
        return found

    def _context_switches(self) -> int:
        return sum(
            int(line.split()[1])
            for task in Path(f"/proc/{self.screen.pid}/task").iterdir()
            for line in (task / "status").read_text().splitlines()
            if line.startswith("voluntary_ctxt")
        )


def watch(desktops: list[Measured], seconds: float, held: tuple[str, ...]) -> None:
    """Read what all of them write for so long, typing what is held down."""
    deadline = time.perf_counter() + seconds
    keys, next_key = itertools.cycle(held), time.perf_counter()
    by_number = {each.screen._fd: each.screen for each in desktops}
    while (now := time.perf_counter()) < deadline:
        if held and now >= next_key:
            key = next(keys)
            for each in desktops:
                each.screen.send(key)
            next_key += REPEAT
        until = min(deadline, next_key) if held else deadline
        for number in select.select(list(by_number), [], [], max(0.0, until - time.perf_counter()))[0]:
            by_number[number].output += os.read(number, 65536)


def measure(scene: Scene, pythons: list[str], seconds: float) -> list[Measured]:
    """Bring the scene up in each and measure all of them at the same time."""
    desktops: list[Measured] = []
    try:
        desktops += [Measured(python, scene) for python in pythons]
        # All at once, and read all the time: what is compared has run for the same time (a turtle that drives is slower to draw
        # while its trail grows), and no desktop has taken its terminal for one on a slow line.
        with ThreadPoolExecutor(len(desktops)) as threads:
            list(threads.map(lambda desktop: (desktop.screen.first_frame(), scene.prepare(desktop.screen)), desktops))
        watch(desktops, 2.0, scene.held)
        for desktop in desktops:
            desktop.begin()
        watch(desktops, seconds, scene.held)
        for desktop in desktops:
            desktop.end()
    finally:
        for desktop in desktops:
            desktop.screen.__exit__()
    return desktops


def main() -> int:
    """Measure the scenes and print a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--beside", metavar="PYTHON", help="the interpreter of another installation")
    parser.add_argument("--scene", action="append", choices=SCENES, help="one of the scenes (default: all)")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--threads", action="store_true", help="list each thread")
    parser.add_argument("--desktops", type=int, default=1, metavar="N", help="so many at once, and their mean")
    options = parser.parse_args()
    others = [options.beside] if options.beside else []
    print("| scene | CPU % | wake-ups/s | bytes/s | beside: CPU % | wake-ups/s | bytes/s | ratio |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for name in options.scene or SCENES:
        rows: list[list[float]] = []
        for _ in range(options.rounds):
            done = measure(SCENES[name], [*others, *[sys.executable] * options.desktops], options.seconds)
            before, ours = done[: len(others)], done[len(others) :]
            row = [statistics.mean(figure(each) for each in ours) for figure in FIGURES]
            row += [figure(each) for each in before for figure in FIGURES]
            rows.append(row)
            if options.threads:
                for each in done:
                    print("  ", {thread: f"{cpu:.2f}" for thread, cpu in each.by_thread.items() if cpu > 0.02})
        figures = [statistics.median(column) for column in zip(*rows, strict=True)]
        cells = [f"{figures[0]:.2f}", *(f"{figure:.0f}" for figure in figures[1:3])]
        if others:
            ratio = statistics.median(row[0] / row[3] for row in rows)
            cells += [f"{figures[3]:.2f}", *(f"{figure:.0f}" for figure in figures[4:6]), f"{ratio:.2f}"]
        print(f"| {name} | {' | '.join(cells)} |", flush=True)
    return 0


FIGURES: tuple[Callable[[Measured], float], ...] = (
    lambda each: each.cpu,
    lambda each: each.switches,
    lambda each: each.bytes,
)

if __name__ == "__main__":
    sys.exit(main())
