"""rviz2: RViz as a node with a window.

What it does without a screen is the rule of `programs/_without_screen.py`; as a node it logs warnings and errors of its
displays. The command line is that of rviz_common/visualizer_app.cpp.
"""

from __future__ import annotations

import argparse
import time
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from day6_core.reason import reason
from day6_core.ros.programs._without_screen import stays
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from day6_core.ros.programs.rviz2.model.config import ConfigError
from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.frames import FrameBuffer
from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.status import ERROR, WORDS, Status
from day6_core.ros.programs.rviz2.reading import Reader
from day6_core.ros.programs.tf2_ros.listening import listen
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.properties import Property
    from day6_core.session.session import Session

SETTLE_SECONDS = 2.0
"""Without a screen: how long to listen before telling."""

LOOK_SECONDS = 1.0
"""How often statuses are looked at when nothing happens (VisualizationManager::onUpdate)."""

SHARE = 0.2
"""Of the time that ticks may take."""

RESTLESS_SECONDS = 0.2
"""How often a picture is made that changes by time alone."""

HELP = """\
Usage: rviz2 [options]
3D visualization tool for ROS2

Options:
  -h, --help                                         Displays help on
                                                     commandline options.
  --help-all                                         Displays help including Qt
                                                     specific options.
  -t, --display-title-format <display_title_format>  A display title format
                                                     like "{NAMESPACE} -
                                                     {CONFIG_PATH}/{CONFIG_FILENAME}
                                                     - RViz2"
  -d, --display-config <display_config>              A display config file
                                                     (.rviz) to load
  -f, --fixed-frame <fixed_frame>                    Set the fixed frame
  -l, --ogre-log                                     Enable the Ogre.log file
                                                     (output in cwd) and console
                                                     output.
  -s, --splash-screen <splash_path>                  A custom splash-screen
                                                     image to display
  --fullscreen                                       Start RViz in fullscreen
                                                     mode.
"""


class UsageError(Exception):
    """The command line is wrong."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise UsageError(message)


def parse_arguments(argv: list[str]) -> argparse.Namespace:
    """Read the options that are not ROS's. Raises UsageError."""
    parser = _Parser(prog="rviz2", add_help=False, allow_abbrev=False)
    parser.add_argument("-h", "--help", "--help-all", action="store_true")
    parser.add_argument("-t", "--display-title-format", default="")
    parser.add_argument("-d", "--display-config", default="")
    parser.add_argument("-f", "--fixed-frame", default="")
    parser.add_argument("-l", "--ogre-log", action="store_true")
    parser.add_argument("-s", "--splash-screen", default="")
    parser.add_argument("--fullscreen", action="store_true")
    arguments, unknown = parser.parse_known_args(without_ros_arguments(argv))
    options = [each for each in unknown if each.startswith("-")]
    if options:
        # Qt's sentence.
        raise UsageError(f"Unknown option '{options[0].lstrip('-')}'.")
    return arguments


def without_ros_arguments(argv: list[str]) -> list[str]:
    """The command line without what stands between `--ros-args` and `--`."""
    left, inside = [], False
    for each in argv:
        if each == "--ros-args":
            inside = True
        elif inside and each == "--":
            inside = False
        elif not inside:
            left.append(each)
    return left


def default_config() -> str:
    """The configuration RViz starts with (rviz_common/default.rviz)."""
    share = Path(__file__).resolve().parents[2] / "share"
    return (share / "rviz_common" / "default.rviz").read_text(encoding="utf-8")


async def main(session: Session) -> int:
    """Follow the graph until the window is closed or the program interrupted."""
    try:
        options = parse_arguments(session.argv[1:])
    except UsageError as error:
        session.print_error(f"rviz2: {error}")
        return 1
    if options.help:
        session.print(HELP, end="")
        return 0
    node = create_node(session, "rviz")
    cache_ms = node.declare_parameter("tf_buffer_cache_time_ms", 10000).value
    from rclpy.duration import Duration

    buffer = FrameBuffer(Duration(nanoseconds=max(0, int(cache_ms)) * 1_000_000))
    rviz = RViz(node, buffer, partial(session.timer_ns, node), session.clock.now_ns)
    session.defer(rviz.close)
    changed = Signal()
    rviz.wake = changed.set
    reader = Reader(session, rviz)
    rviz.read_robot, rviz.read_file, rviz.read_mesh = reader.robot, reader.file, reader.mesh
    rviz.write_file, rviz.path = reader.write, reader.path
    rviz.is_of_this_machine = reader.is_of_this_machine
    listener = listen(session, buffer)
    _configure(session, rviz, options)
    session.spawn(session.spin(node, listener))
    if session.display is None:
        if not stays(session, node):
            return await _print_panel(session, rviz, changed)
        try:
            await _log(session, rviz, changed)
        except STOPPED:
            log_interrupt(session)
        return 0
    # The picture needs numpy, whose import would make the desktop stutter.
    await in_thread(_load_numpy)
    rviz.tick()
    window = session.display.open("rviz2", _title(rviz, options.display_title_format), rviz)
    try:
        await _run(session, rviz, changed)
    except STOPPED:
        if not window.closed:
            log_interrupt(session)
    return 0


def _load_numpy() -> None:
    import numpy  # noqa: F401


def _configure(session: Session, rviz: RViz, options: argparse.Namespace) -> None:
    """Load the file that was named, or the user's own default, or ours."""
    home = session.env.get("HOME")
    own = Path(home) / ".rviz2" / "default.rviz" if home else None
    rviz.default_file = own
    name = options.display_config
    path = session.path(name) if name else own
    text = default_config()
    if path is not None and path.is_file():
        try:
            rviz.load_text(path.read_text(encoding="utf-8", errors="replace"))
            rviz.config_file = path
        except (OSError, ConfigError) as error:
            rviz.load_text(text)
            rviz.hint("rviz.hint.config", file=path.name, reason=reason(error))
            node_logger = rviz.node.get_logger()
            node_logger.error(f"{path}: {reason(error)}")
    else:
        rviz.load_text(text)
        if name:
            rviz.hint("rviz.hint.no_config", file=name)
            rviz.node.get_logger().error(f"Could not load display config file '{name}'")
    if options.fixed_frame:
        rviz.fixed.set(options.fixed_frame)


def _title(rviz: RViz, title_format: str) -> str:
    """The window's title: the file's name, or what the format makes of it."""
    file = rviz.config_file
    if not title_format:
        return f"{file.name} - RViz" if file is not None else "RViz"
    names = {
        "{NAMESPACE}": rviz.node.get_namespace(),
        "{CONFIG_PATH}": str(file.parent) if file is not None else "",
        "{CONFIG_FILENAME}": file.name if file is not None else "default.rviz",
    }
    for key, value in names.items():
        title_format = title_format.replace(key, value)
    return title_format


async def _run(session: Session, rviz: RViz, changed: Signal) -> None:
    """Tick when something changed, at most as often as can be seen."""
    while True:
        changed.clear()
        began = time.thread_time()
        rviz.tick()
        cost = time.thread_time() - began
        # A robot of thousands of links must leave time to the others on this thread.
        period = max(1 / max(1, rviz.frame_rate.value), rviz.pace, min(cost / SHARE, LOOK_SECONDS))
        # A user's request is handled at once, even while the world is paused.
        await session.wait(rviz.urgent, period)
        rviz.urgent.clear()
        await session.wait(changed, RESTLESS_SECONDS if rviz.restless else LOOK_SECONDS)


async def _print_panel(session: Session, rviz: RViz, changed: Signal) -> int:
    """Without a screen: print the panel after a while."""
    await _settle(session, rviz, changed)
    for line in panel_text(rviz):
        session.print(line)
    return 0


async def _log(session: Session, rviz: RViz, changed: Signal) -> None:
    """Without a screen, as a node: say once what each display warns of."""
    await _settle(session, rviz, changed)
    logger = rviz.node.get_logger()
    known: set[str] = set()
    while True:
        now = troubles(rviz)
        for text, level in now.items():
            if text in known:
                continue
            # Two lines: rclpy refuses another severity from the same one.
            if level == ERROR:
                logger.error(text)
            else:
                logger.warning(text)
        known = set(now)
        await session.sleep(LOOK_SECONDS)
        changed.clear()
        rviz.tick()


async def _settle(session: Session, rviz: RViz, changed: Signal) -> None:
    end = session.clock.steady_ns() + int(SETTLE_SECONDS * 1e9)
    while session.clock.steady_ns() < end:
        await session.wait(changed, 0.1)
        changed.clear()
        rviz.tick()


def troubles(rviz: RViz) -> dict[str, int]:
    """What is not well, as texts, with how bad it is."""
    return {f"{owner}: {line.name}: {line.value}": line.level for owner, line in rviz.problems()}


def panel_text(rviz: RViz) -> list[str]:
    """The panel as text: the Fixed Frame, every display with its statuses."""
    lines = [f"Fixed Frame: {rviz.fixed_frame}", *_statuses(rviz.statuses, "")]
    for display in rviz.displays:
        indent, group = "", display.parent
        while isinstance(group, Display):
            indent, group = indent + "  ", group.parent
        kind = display.class_id.rpartition("/")[2]
        lines.append(f"{indent}{display.name} ({kind}){'' if display.enabled else ': disabled'}")
        if display.enabled and display.statuses.children:
            lines += _statuses(display.statuses, indent + "  ")
    return lines


def _statuses(statuses: Property, indent: str) -> list[str]:
    lines = [f"{indent}{statuses.name}"]
    for line in statuses.children:
        if isinstance(line, Status):
            lines.append(f"{indent}  {WORDS[line.level]}: {line.name}: {line.value}")
    return lines
