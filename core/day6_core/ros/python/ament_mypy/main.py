"""Runs mypy with the settings of ROS: a package that is imported may have no types. mypy is not installed with day6-tui."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib.util import find_spec

from ament_lint.files import files_below, parser_for


def main(argv: list[str] | None = None) -> int:
    """Check the given files and folders (by default the current one); returns mypy's status, 1 without anything to check."""
    parser = parser_for("ament_mypy", "Check types with mypy.")
    parser.add_argument("--config", metavar="path", help="a configuration of mypy in place of that of ROS")
    parser.add_argument("--cache-dir", metavar="cache", default=os.devnull, help="where mypy keeps what it knows")
    chosen = parser.parse_args(sys.argv[1:] if argv is None else argv)
    if find_spec("mypy") is None:
        print("mypy is not installed (pip install mypy)", file=sys.stderr)
        return 1
    if chosen.config and not os.path.exists(chosen.config):
        print(f"Could not find config file '{chosen.config}'", file=sys.stderr)
        return 1
    files = sorted(path for path in files_below(chosen.paths, ".py") if os.path.basename(path) not in chosen.exclude)
    if not files:
        print("No files found", file=sys.stderr)
        return 1
    settings = ["--config-file", chosen.config] if chosen.config else ["--config-file=", "--ignore-missing-imports"]
    settings += ["--cache-dir", chosen.cache_dir, *(["--no-incremental"] if chosen.cache_dir == os.devnull else [])]
    print(f"\n{len(files)} files checked", flush=True)
    words = [sys.executable, "-m", "mypy", "--show-error-context", "--show-column-numbers", *settings, *files]
    done = subprocess.run(words, capture_output=True, text=True, encoding="utf-8")
    print(done.stdout, end="")
    print(done.stderr, end="", file=sys.stderr)
    return done.returncode
