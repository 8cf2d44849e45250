"""Programs that fail, run as a terminal runs them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from day6_core.ros.environment import program_environment


def failed(program: str, folder: Path, name: str = "p.py") -> str:
    """Run a program as a terminal does; return all it wrote."""
    (folder / name).write_text(program, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, name],
        cwd=folder,
        env=program_environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
    )
    assert done.returncode
    return done.stdout
