"""The processes that a launch needs: `python3 …/launch/_process KIND …`.

- `launch OPTIONS`: the launch itself; OPTIONS is JSON from the `ros2 launch` command, in the folder around this one.
- `program FILE ARG…`, `command NAME ARG…`: one of our executables or commands as a separate process, for launches that
  weren't started by `ros2 launch`. The package `launch`, which starts them, knows only the path of this folder.

It is a folder, so that only this file comes first on `sys.path`: no module of `ros2`, none of the current folder.
"""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from day6_core.session.session import Main, Session


def main(kind: str, *arguments: str) -> int:
    if kind == "launch":
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # no traceback of ours while modules are being loaded
    _become_a_ros_program()
    if kind == "launch":
        import json

        return _launch(json.loads(arguments[0]))
    signal.signal(signal.SIGINT, _on_interrupt)
    return _run_ours(kind, list(arguments))


def _become_a_ros_program() -> None:
    sys.path[0] = os.path.abspath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 3, "python"))
    from day6_core.ros.environment import program_environment

    os.environ.update(program_environment())


def _launch(options: dict[str, Any]) -> int:
    """Launch, print or list the arguments of `path`, with the options that `ros2 launch` hands on.

        `terminals` are the names of the terminals that the starting process can open. `guarded` is for the user's own terminal,
    which isn't an emulation of ours: it gets coloured lines and nothing else.
    """
    if options["guarded"]:
        from day6_core.session.harmless import guard_standard_streams

        guard_standard_streams()
    from launch._host import connect

    host = connect(options["terminals"])
    from launch import LaunchDescription, LaunchService
    from launch.actions import IncludeLaunchDescription
    from launch.launch_description_sources import AnyLaunchDescriptionSource

    path = options["path"]
    if options["show"] == "plan":
        from day6_core.ros.ros2.launch._plan import show_plan

        return show_plan(options)
    if options["show"]:
        from launch.invalid_launch_file_error import InvalidLaunchFileError

        try:
            show_arguments(path) if options["show"] == "arguments" else show_description(path)
        except InvalidLaunchFileError as error:
            sys.stderr.write(f"{type(error).__module__}.{type(error).__qualname__}: {error}\n")
            return 1
        return 0
    try:
        noninteractive = options["noninteractive"] or not sys.stdin.isatty()
    except (AttributeError, ValueError):
        noninteractive = True
    service = LaunchService(
        argv=options["argv"],
        noninteractive=noninteractive,
        debug=options["debug"],
        log_file_name=options["log_file_name"],
    )
    service._run_programs_with(host)
    source = AnyLaunchDescriptionSource(path)
    include = IncludeLaunchDescription(source, launch_arguments=[(name, value) for name, value in options["arguments"]])
    service.include_launch_description(LaunchDescription([include]))
    return service.run()


def show_description(path: str) -> None:
    """Print the launch description (`ros2 launch --print`)."""
    from launch import LaunchIntrospector
    from launch.launch_description_sources import get_launch_description_from_any_launch_file

    print(LaunchIntrospector().format_launch_description(get_launch_description_from_any_launch_file(path)))


def show_arguments(path: str) -> None:
    """Print the launch file's arguments (`ros2 launch --show-args`)."""
    from launch.launch_description_sources import get_launch_description_from_any_launch_file
    from launch_testing.print_arguments import print_arguments_of_launch_description

    print_arguments_of_launch_description(launch_description=get_launch_description_from_any_launch_file(path))


def _run_ours(kind: str, argv: list[str]) -> int:
    from day6_core.session.local import run_local

    if kind == "program":
        from day6_core.ros.program_index import named_by
        from day6_core.ros.programs import load

        found = named_by(Path(argv[0]))
        if found is None:
            print(f"{argv[0]}: no program of day6-tui", file=sys.stderr)
            return 127
        status = run_local(_taking_over(load(*found)), argv)
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # unlike a handler it stays in force until Python has ended
        return 0 if status == 130 else status  # a well-written node exits cleanly on Ctrl-C
    command = _ros_command(argv[0].rpartition("/")[2])
    if command is None:
        print(f"{argv[0]}: command not found", file=sys.stderr)
        return 127
    return run_local(_taking_over(command), argv, one_shot=True)


def _ros_command(name: str) -> Main | None:
    """Return the entry point of a ROS command, None for any other name."""
    if name == "ros2":
        from day6_core.ros.ros2 import main

        return main
    if name == "launch_test":
        return _launch_test
    from day6_core.ros.program_index import COMMANDS
    from day6_core.ros.programs import load

    return load(*COMMANDS[name]) if name in COMMANDS else None


async def _launch_test(session: Session) -> int:
    return await session.run_python(["-m", "launch_testing.launch_test", *session.argv[1:]])


_started = False
"""Whether the program has taken over the handling of Ctrl-C."""


def _on_interrupt(number: int, frame: object) -> None:
    """End this process quietly while it is still loading; do nothing once its program has started.

    Where the launch has no terminal Ctrl-C arrives twice: from the terminal's process group, and from the launch.
    """
    if not _started:
        os._exit(130 if sys.argv[1:2] == ["command"] else 0)


def _taking_over(program: Main) -> Main:
    async def main(session: Session) -> int | None:
        global _started
        _started = True
        return await program(session)

    return main


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
