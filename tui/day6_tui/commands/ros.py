"""The commands of ROS: `ros2`, `colcon`, and programs that are commands of their own, on this machine's graph."""

from __future__ import annotations

import importlib
import signal
from typing import TYPE_CHECKING

from day6_core.session.local import has_terminal, run_local

if TYPE_CHECKING:
    from day6_core.session.local import Foreground


def ros2(argv: list[str]) -> int:
    """`ros2 …`."""
    words = argv[1:]
    lasting = words[:1] in (["run"], ["launch"], ["daemon"], ["bag"]) or "echo" in words or "hz" in words
    show = _show_window if words[:1] == ["run"] and has_terminal() else None
    main = importlib.import_module("day6_core.ros.ros2").main
    status = run_local(main, argv, one_shot=not lasting, show=show)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a second Ctrl-C comes too late to change how it has ended
    return status


def colcon(argv: list[str]) -> int:
    """`colcon …`."""
    from day6_core.workspace.command import main

    return run_local(main, argv, one_shot=True)


def program(argv: list[str]) -> int:
    """rqt_graph, rviz2, check_urdf …."""
    from day6_core.ros.program_index import COMMANDS
    from day6_core.ros.programs import load

    return run_local(load(*COMMANDS[argv[0]]), argv, show=_show_window if has_terminal() else None)


def _show_window(foreground: Foreground) -> None:
    """Draw the program's window. A program without one never calls this, and Textual is not imported for it."""
    from day6_tui.window_app import show

    show(foreground)
