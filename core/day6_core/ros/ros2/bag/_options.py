"""Shared by the verbs of `ros2 bag`: checked values of options, paths, the texts of ros2bag/api."""

from __future__ import annotations

import os
from argparse import ArgumentParser, ArgumentTypeError
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.completion import CompletionContext
from day6_core.ros.ros2.cli.options import completed
from day6_core.whole_file import open_at_once

if TYPE_CHECKING:
    from rosbag2_py._console import Log

    from day6_core.session.session import Session
    from rclpy.node import Node
    from rclpy.qos import QoSProfile

STORAGES = ("mcap", "sqlite3")
LOG_LEVELS = ("debug", "info", "warn", "error", "fatal")


def error(text: str) -> str:
    """Return an error line as ros2bag words it."""
    return f"[ERROR] [ros2bag]: {text}"


def warning(text: str) -> str:
    """Return a warning line as ros2bag words it."""
    return f"[WARN] [ros2bag]: {text}"


def positive_float(text: str) -> float:
    """The argparse type of a rate."""
    value = _float(text)
    if value <= 0.0:
        raise ArgumentTypeError(f"{text} is not in the valid range (> 0.0)")
    return value


def not_negative_float(text: str) -> float:
    """The argparse type of a time span."""
    value = _float(text)
    if value < 0.0:
        raise ArgumentTypeError(f"Value {text} is less than zero.")
    return value


def _float(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise ArgumentTypeError(f"{text} is not the valid type (float)") from None


def not_negative_int(text: str) -> int:
    """The argparse type of a number."""
    try:
        value = int(text)
    except ValueError:
        raise ArgumentTypeError(f"{text} is not the valid type (int)") from None
    if value < 0:
        raise ArgumentTypeError(f"Value {value} is less than zero.")
    return value


def regular_expression(text: str) -> str:
    """The argparse type of a regular expression."""
    import re

    from day6_core.user_pattern import user_pattern

    try:
        user_pattern(text)
    except re.error as problem:
        raise ArgumentTypeError(f"'{text}' is not a regular expression: {problem}") from None
    return text


def console(session: Session, *paths: str, least: str = "info") -> Log:
    """Return what prints the log lines of rosbag2's libraries from a level on, with the paths as the user has typed them."""

    def log(level: str, logger: str, text: str) -> None:
        if LOG_LEVELS.index(level.lower()) < LOG_LEVELS.index(least):
            return
        for path in paths:
            text = text.replace(str(Path(session.cwd, path)), path)
        if not any(map(os.path.isabs, paths)):
            text = text.replace(os.path.join(session.cwd, ""), "")  # bags that a file of options names
        seconds, nanoseconds = divmod(session.clock.now_ns(), 1_000_000_000)
        session.print_error(f"[{level}] [{seconds}.{nanoseconds:09d}] [{logger}]: {text}")

    return log


def set_log_level(node: Node, level: str) -> None:
    """Set the log level of a node, a name of LOG_LEVELS."""
    from rclpy.logging import LoggingSeverity

    node.get_logger().set_level(LoggingSeverity[level.upper()])


def path_of(parser: Any, text: str) -> str:
    """Return a path resolved against the working directory: that of the session, or of the program that imported ros2bag."""
    session = getattr(parser, "session", None)
    return text if session is None else str(Path(session.cwd, text))


def path_in(session: Session, text: str | None) -> str:
    """Return a path resolved against the session's working directory, '' for none."""
    return str(Path(session.cwd, text)) if text else ""


def readable_file(parser: Any) -> Callable[[str], str]:
    """Return the argparse type of a file that is read, in the words of argparse.FileType."""

    def check(text: str) -> str:
        try:
            with open(path_of(parser, text), "rb", opener=open_at_once):
                return text
        except OSError as problem:
            raise ArgumentTypeError(
                f"can't open '{text}': [Errno {problem.errno}] {problem.strerror}: '{text}'"
            ) from None

    return check


def existing_path(parser: Any) -> Callable[[str], str]:
    """Return the argparse type of a bag's path, which must exist."""

    def check(text: str) -> str:
        if not Path(path_of(parser, text)).exists():
            raise ArgumentTypeError(f"Bag path '{text}' does not exist!")
        return text

    return check


def add_bag_path(parser: ArgumentParser, *, required: bool = True, storage: bool = True) -> None:
    """Add the bag to open and, where it can be given, its storage format."""
    bag = parser.add_argument(
        "bag_path", nargs=None if required else "?", type=existing_path(parser), help="Bag to open"
    )
    completed(bag, bag_names)
    if not storage:
        parser.set_defaults(storage="")
        return
    add_storage(parser)


def add_storage(parser: ArgumentParser) -> None:
    """Add the storage format of a bag to read."""
    parser.add_argument(
        "-s",
        "--storage",
        default="",
        choices=STORAGES,
        help="Storage implementation of bag. By default attempts to detect automatically - use this argument to override.",
    )


def bag_names(context: CompletionContext) -> list[str]:
    """Complete the path of a bag: a folder with metadata.yaml, a .mcap or .db3 file."""
    head, _, _ = context.prefix.rpartition("/")
    folder = Path(context.session.cwd, head or ("/" if context.prefix.startswith("/") else ""))
    start = f"{head}/" if "/" in context.prefix else ""
    try:
        entries = sorted(folder.iterdir())
    except OSError:
        return []
    bags = [entry.name for entry in entries if (entry / "metadata.yaml").is_file() or entry.suffix in (".mcap", ".db3")]
    return [start + name for name in bags]


def add_qos_overrides(parser: ArgumentParser) -> None:
    """Add the file of QoS overrides."""
    parser.add_argument(
        "--qos-profile-overrides-path",
        type=readable_file(parser),
        help="Path to a yaml file defining overrides of the QoS profile for specific topics.",
    )


def qos_overrides(session: Session, path: str | None) -> dict[str, QoSProfile]:
    """Read the file of QoS overrides. Raises RuntimeError with ros2bag's text if it is wrong."""
    if not path:
        return {}
    import yaml
    from rosbag2_py._options import qos_overrides as parse

    from rclpy.qos import InvalidQoSProfileException

    try:
        return parse(yaml.safe_load(Path(session.cwd, path).read_text(encoding="utf-8")))
    except OSError as problem:
        raise RuntimeError(
            error(f"can't open '{path}': [Errno {problem.errno}] {problem.strerror}: '{path}'")
        ) from None
    except (InvalidQoSProfileException, ValueError, TypeError, yaml.YAMLError) as problem:
        raise RuntimeError(error(str(problem))) from None


def event_topics(services: list[str] | None) -> list[str]:
    """Return the service event topics of `services`."""
    return [f"{service}/_service_event" for service in services or ()]


def repeated_topics(words: list[str]) -> dict[str, int]:
    """Return how many messages of which topics are repeated: `/map=3`. Raises ValueError with ros2bag's text."""
    found = {}
    for word in words:
        topic, equal, depth = word.partition("=")
        start = f'Invalid value for --repeat-transient-local: "{word}".'
        if not topic:
            raise ValueError(f"{start} Topic name must not be empty.")
        if equal and not depth:
            raise ValueError(f"{start} Expected format <topic> or <topic>=<depth>.")
        start = start.replace("value", "depth", 1)
        try:
            found[topic] = int(depth or 1)
        except ValueError:
            raise ValueError(f"{start} Depth must be a positive integer.") from None
        if found[topic] <= 0:
            raise ValueError(f"{start} Depth must be greater than 0.")
    return found
