"""`ros2 launch`: finds the launch file, checks the arguments, and starts the launch as a separate process.

The process is `_process` in this folder: a launch file is its author's program, and neither it nor what it launches may
block this one. In the desktop (or `day6-tui exec`) this process runs those of our programs that it launches, with their
windows; see `_host`. In a real terminal they are processes like all others.
"""

from __future__ import annotations

import json
import os
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from day6_core.ros import differences
from day6_core.ros.environment import LAUNCH_PROCESS
from day6_core.ros.ros2.cli.completion import CompletionContext, package_names
from day6_core.ros.ros2.cli.options import completed
from day6_core.session.real_streams import RealOutput

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Run a launch file"
_EXTENSIONS = ("launch.py", "launch.xml", "xml", "launch", "launch.yaml", "launch.yml", "yaml", "yml")
"""The endings of launch file names."""


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
    parser.add_argument("-f", "--log-file-name", help="Name of the logging file")
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
    rest.required = True  # Python before 3.13 lists it among the missing arguments


async def main(session: Session, args: Namespace) -> int:
    path, arguments = launch_file(
        session.cwd, session.env, args.package_name, args.launch_file_name, args.launch_arguments
    )
    if args.launch_prefix is None and args.launch_prefix_filter is not None:
        raise RuntimeError("--launch-prefix must be specified if --launch-prefix-filter is provided")
    if args.launch_prefix:
        arguments.append(f"launch-prefix:={args.launch_prefix}")
    if args.launch_prefix_filter:
        arguments.append(f"launch-prefix-filter:={args.launch_prefix_filter}")
    show = "description" if args.print else "arguments" if args.show_args else ""
    options: dict[str, object] = {
        "path": path,
        "argv": arguments,
        "arguments": [] if show else list(parsed_arguments(arguments).items()),
        "debug": args.debug,
        "log_file_name": args.log_file_name,
        "noninteractive": args.noninteractive,
        "show": show,
        "guarded": isinstance(session.stdout, RealOutput),
        "terminals": (),
    }
    env = dict(session.env)
    if args.show_all_subprocesses_output:
        env["OVERRIDE_LAUNCH_PROCESS_OUTPUT"] = "both"
    if session.host is None and os.name == "posix":
        _become_python(session, _words(options), env)
    if not show and session.host is not None and session.host.starts_programs:
        from day6_core.ros.ros2.launch._host import VARIABLE, LaunchHost

        host = LaunchHost(session, session.host)
        session.defer(host.close)
        env[VARIABLE] = host.address
        options["terminals"] = session.host.terminals
    session.env = env
    return await session.run_python(_words(options))


def _words(options: dict[str, object]) -> list[str]:
    """Return the arguments of the Python process that launches."""
    return [str(LAUNCH_PROCESS), "launch", json.dumps(options)]


def _become_python(session: Session, words: list[str], env: dict[str, str]) -> NoReturn:
    """Replace this process with the launch: a `ros2` in a real terminal has nothing left to do."""
    session.stdout.flush()
    session.stderr.flush()
    os.chdir(session.cwd)
    os.execve(sys.executable, [sys.executable, *words], env)


def launch_file(
    folder: Path, env: Mapping[str, str], package: str, name: str | None, words: Iterable[str]
) -> tuple[str, list[str]]:
    """Return the path (relative to the folder if so given) and the arguments of a launch file that a command names.

    It is that of a package, or at a path in place of the package, and then the name is an argument, too. Raises RuntimeError.
    """
    if (folder / package).is_file():
        return package, [*([] if name is None else [name]), *words]
    from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

    try:
        share = get_package_share_directory(package, environment=env)
    except PackageNotFoundError as error:
        raise RuntimeError(f"Package '{package}' not found: {error}") from None
    found = [
        os.path.join(below, file)
        for below, _, files in os.walk(share)
        for file in sorted(files)
        if differences.launch_file(package, file) == name
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
    return found[0], list(words)


def parsed_arguments(words: list[str]) -> dict[str, str]:
    """Return `{name: value}` of the words `name:=value`. Raises RuntimeError for any other word."""
    found: dict[str, str] = {}
    for word in words:
        name, separator, value = word.partition(":=")
        if not separator or not name or (not value and word.count(":=") == 1):
            raise RuntimeError(f"malformed launch argument '{word}', expected format '<name>:=<value>'")
        found.pop(name, None)
        found[name] = value
    return found


def packages_and_files(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a package, or the path of a launch file."""
    folder = os.path.dirname(context.prefix)
    begun = folder.rstrip("/") + "/" if folder else ""
    where = context.session.path(begun)
    try:
        entries = sorted(where.iterdir())
    except OSError:
        entries = []
    hidden = os.path.basename(context.prefix).startswith(".")
    shown = [each for each in entries if hidden or not each.name.startswith(".")]
    folders = [f"{begun}{each.name}/" for each in shown if each.is_dir()]
    files = [f"{begun}{each.name}" for each in shown if _is_launch_file(each)]
    return [*([] if begun else package_names(context)), *folders, *files]


def launch_file_names(context: CompletionContext) -> Iterable[str]:
    """Complete the names of launch files of the package named before; after a file, its arguments."""
    if _named_file(context).is_file():
        return launch_arguments(context)
    share = _named_share(context)
    package = context.values.get("package_name", "")
    files = Path(share).rglob("*") if share else ()
    names = (differences.launch_file(package, path.name) for path in files if _is_launch_file(path))
    return [name for name in names if name]  # '' is not in this distribution


def launch_arguments(context: CompletionContext) -> Iterable[str]:
    """Complete `name:=`, then the value, of an argument that the launch file declares."""
    from day6_core.ros.ros2.launch._declared import find_file, offered

    file: Path | None = _named_file(context)
    if file is None or not file.is_file():
        share = _named_share(context)
        file = find_file(share, context.values.get("launch_file_name", "")) if share else None
    return offered(file, context.prefix, context.words) if file is not None else []


def _named_file(context: CompletionContext) -> Path:
    """Return the first word as a path."""
    return context.session.path(context.values.get("package_name", ""))


def _named_share(context: CompletionContext) -> str:
    from ament_index_python.packages import get_package_share_directory

    try:
        return str(
            get_package_share_directory(
                context.values.get("package_name", ""), print_warning=False, environment=context.session.env
            )
        )
    except (KeyError, ValueError):
        return ""


def _is_launch_file(path: Path) -> bool:
    return path.name.endswith(_EXTENSIONS) and path.name != "package.xml" and path.is_file()
