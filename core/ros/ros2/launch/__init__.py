"""`ros2 launch`: finds the launch file, checks the arguments, and starts the launch as a process of its own.

The process is `core/ros/python/launch/_process`: a launch file is its author's program, and neither it nor what it launches may
hold up this one. Programs of ours that it launches come back here to be run, with their windows, if this is in the desktop (or
`day6-tui exec`); see `_host`. In a real terminal they are processes like all others.
"""

from __future__ import annotations

import json
import os
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from day6_tui.core.ros.environment import PYTHON_PATH
from day6_tui.core.ros.ros2.cli.completion import Typed, package_names
from day6_tui.core.ros.ros2.cli.options import completed
from day6_tui.core.session.real_streams import RealOutput

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

SUMMARY = "Run a launch file"
_PROCESS = PYTHON_PATH / "launch" / "_process"
_EXTENSIONS = ("launch.py", "launch.xml", "xml", "launch", "launch.yaml", "launch.yml", "yaml", "yml")
"""How the names of launch files end."""


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "-n",
        "--noninteractive",
        action="store_true",
        help="Run the launch system non-interactively, with no terminal associated",
    )
    parser.add_argument(
        "-d",
        "--debug",
        action="store_true",
        help="Put the launch system in debug mode, provides more verbose output.",
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "-p",
        "--print",
        "--print-description",
        action="store_true",
        help="Print the launch description to the console without launching it.",
    )
    group.add_argument(
        "-s",
        "--show-args",
        "--show-arguments",
        action="store_true",
        help="Show arguments that may be given to the launch file.",
    )
    parser.add_argument(
        "-a",
        "--show-all-subprocesses-output",
        action="store_true",
        help="Show all launched subprocesses' output by overriding their output configuration using the "
        "OVERRIDE_LAUNCH_PROCESS_OUTPUT envvar.",
    )
    parser.add_argument(
        "--launch-prefix",
        help="Prefix command, which should go before all executables. Command must be wrapped in quotes if it contains "
        "spaces (e.g. --launch-prefix 'xterm -e gdb -ex run --args').",
    )
    parser.add_argument(
        "--launch-prefix-filter",
        help="Regex pattern for filtering which executables the --launch-prefix is applied to by matching the "
        "executable name.",
    )
    completed(
        parser.add_argument("package_name", help="Name of the ROS package which contains the launch file"),
        packages_and_files,
    )
    completed(parser.add_argument("launch_file_name", nargs="?", help="Name of the launch file"), launch_file_names)
    rest = completed(
        parser.add_argument(
            "launch_arguments",
            nargs="*",
            help="Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)",
        ),
        launch_arguments,
    )
    rest.required = True  # Pythons before 3.13 name it among the missing ones


async def main(session: Session, args: Namespace) -> int:
    path, arguments = _path_and_words(session, args)
    if args.launch_prefix is None and args.launch_prefix_filter is not None:
        raise RuntimeError("--launch-prefix must be specified if --launch-prefix-filter is provided")
    if args.launch_prefix:
        arguments.append(f"launch-prefix:={args.launch_prefix}")
    if args.launch_prefix_filter:
        arguments.append(f"launch-prefix-filter:={args.launch_prefix_filter}")
    show = "description" if args.print else "arguments" if args.show_args else ""
    options = {
        "path": path,
        "argv": arguments,
        "arguments": [] if show else list(parsed_arguments(arguments).items()),
        "debug": args.debug,
        "noninteractive": args.noninteractive,
        "show": show,
        "guarded": isinstance(session.stdout, RealOutput),
    }
    env = dict(session.env)
    if args.show_all_subprocesses_output:
        env["OVERRIDE_LAUNCH_PROCESS_OUTPUT"] = "both"
    words = [str(_PROCESS), "launch", json.dumps(options)]
    if session.shell is None and os.name == "posix":
        _become_python(session, words, env)
    if not show and hasattr(session.shell, "desk"):
        from day6_tui.core.ros.ros2.launch._host import VARIABLE, Host

        host = Host(session)
        session.defer(host.close)
        env[VARIABLE] = host.address
    session.env = env
    return await session.run_python(words)


def _become_python(session: Session, words: list[str], env: dict[str, str]) -> NoReturn:
    """Go on as the launch in this very process: that of `ros2` in a real terminal has nothing left to do."""
    session.stdout.flush()
    session.stderr.flush()
    os.chdir(session.cwd)
    os.execve(sys.executable, [sys.executable, *words], env)


def _path_and_words(session: Session, args: Namespace) -> tuple[str, list[str]]:
    """Return the launch file's path, relative to the session's folder as given, and the words that are its arguments."""
    words = list(args.launch_arguments)
    if (session.cwd / args.package_name).is_file():
        if args.launch_file_name is not None:
            words.insert(0, args.launch_file_name)
        return args.package_name, words
    from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

    try:
        share = get_package_share_directory(args.package_name, environment=session.env)
    except PackageNotFoundError as error:
        raise RuntimeError(f"Package '{args.package_name}' not found: {error}") from None
    name, package = args.launch_file_name, args.package_name
    found = [
        os.path.join(folder, file) for folder, _, files in os.walk(share) for file in sorted(files) if file == name
    ]
    if not found:
        raise RuntimeError(
            f"file '{name}' was not found in the share directory of package '{package}' which is at '{share}'"
        )
    if len(found) > 1:
        listed = ", ".join(f"'{each}'" for each in found)
        raise RuntimeError(
            f"file '{name}' was found more than once in the share directory of package '{package}': [{listed}]"
        )
    return found[0], words


def parsed_arguments(words: list[str]) -> dict[str, str]:
    """Return `{name: value}` of the words `name:=value`; RuntimeError for any other word."""
    found: dict[str, str] = {}
    for word in words:
        name, sign, value = word.partition(":=")
        if not sign or not name or (not value and word.count(":=") == 1):
            raise RuntimeError(f"malformed launch argument '{word}', expected format '<name>:=<value>'")
        found.pop(name, None)
        found[name] = value
    return found


def packages_and_files(typed: Typed) -> Iterable[str]:
    """Complete the name of a package, or the path of a launch file."""
    folder = os.path.dirname(typed.prefix)
    begun = folder.rstrip("/") + "/" if folder else ""
    where = _path(typed, begun)
    try:
        entries = sorted(where.iterdir())
    except OSError:
        entries = []
    hidden = os.path.basename(typed.prefix).startswith(".")
    shown = [each for each in entries if hidden or not each.name.startswith(".")]
    folders = [f"{begun}{each.name}/" for each in shown if each.is_dir()]
    files = [f"{begun}{each.name}" for each in shown if _is_launch_file(each)]
    return [*([] if begun else package_names(typed)), *folders, *files]


def launch_file_names(typed: Typed) -> Iterable[str]:
    """Complete the names of launch files of the package that was typed before; after a file, its arguments."""
    if _typed_file(typed).is_file():
        return launch_arguments(typed)
    share = _typed_share(typed)
    return [path.name for path in Path(share).rglob("*") if _is_launch_file(path)] if share else []


def launch_arguments(typed: Typed) -> Iterable[str]:
    """Complete `name:=`, then the value, of the arguments that the launch file declares."""
    from day6_tui.core.ros.ros2.launch._declared import find_file, offered

    file: Path | None = _typed_file(typed)
    if file is None or not file.is_file():
        share = _typed_share(typed)
        file = find_file(share, typed.values.get("launch_file_name", "")) if share else None
    return offered(file, typed.prefix, typed.words) if file is not None else []


def _typed_file(typed: Typed) -> Path:
    """What the first word would be as a file."""
    return _path(typed, typed.values.get("package_name", ""))


def _path(typed: Typed, text: str) -> Path:
    """A path as it is typed; `~` is the home of the session."""
    home = typed.session.env.get("HOME", "")
    return typed.session.cwd / (home + text[1:] if text.startswith("~/") else text)


def _typed_share(typed: Typed) -> str:
    from ament_index_python.packages import get_package_share_directory

    try:
        return str(
            get_package_share_directory(
                typed.values.get("package_name", ""), print_warning=False, environment=typed.session.env
            )
        )
    except (KeyError, ValueError):
        return ""


def _is_launch_file(path: Path) -> bool:
    return path.name.endswith(_EXTENSIONS) and path.name != "package.xml" and path.is_file()
