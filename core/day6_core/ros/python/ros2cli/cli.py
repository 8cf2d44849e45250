"""The command `ros2` as a function."""

from __future__ import annotations

import sys
from typing import Any


def main(
    *, script_name: str = "ros2", argv: list[str] | None = None, description: str | None = None, extension: Any = None
) -> int:
    """Run `ros2` with arguments, by default those of this process, and return its status."""
    from day6_core.ros.ros2.cli.embedded import run
    from day6_core.ros.ros2.cli.run import run_command

    words = sys.argv[1:] if argv is None else argv
    return run(words, run_command)
