"""Runs flake8 with the settings of ROS if it is installed, else checks the rules that beginners break most often.

Those are: syntax errors (E999), lines over 99 characters (E501), tabs (W191), trailing spaces (W291, W293), the end of the file
(W292, W391), and unused imports (F401).
"""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from importlib.util import find_spec

from ament_lint.files import files_below, parser_for

_LONGEST = 99


def main(argv: list[str] | None = None) -> int:
    """Check the given files and folders; returns 1 if there are errors."""
    return main_with_errors(argv)[0]


def main_with_errors(argv: list[str] | None = None) -> tuple[int, list[str]]:
    """Like `main`; returns (exit status, lines like `./hello/talker.py:3:1: F401 'math' imported but unused`)."""
    parser = parser_for("ament_flake8", "Check style with flake8.")
    parser.add_argument("--config", metavar="path", help="a configuration of flake8 in place of that of ROS")
    parser.add_argument("--linelength", metavar="N", type=int, help="the maximum line length")
    chosen = parser.parse_args(sys.argv[1:] if argv is None else argv)
    if find_spec("flake8") is None:
        errors = _by_ourselves(chosen.paths, chosen.linelength or _LONGEST)
    else:
        settings = ["--isolated", "--extend-ignore=D,B902,C816,I202", f"--max-line-length={_LONGEST}"]
        if chosen.config:
            settings = [f"--config={chosen.config}"]
        if chosen.linelength:
            settings.append(f"--max-line-length={chosen.linelength}")
        if chosen.exclude:
            settings.append(f"--exclude={','.join(chosen.exclude)}")
        errors = _by_flake8([*settings, *chosen.paths])
    for error in errors:
        print(error)
    print(f"\n{len(errors)} errors" if errors else "No problems found")
    return (1 if errors else 0), errors


def _by_flake8(words: list[str]) -> list[str]:
    done = subprocess.run([sys.executable, "-m", "flake8", *words], capture_output=True, text=True, encoding="utf-8")
    return done.stdout.splitlines()


def _by_ourselves(paths: list[str], longest: int) -> list[str]:
    found = []
    for path in sorted(files_below(paths, ".py")):
        with open(path, encoding="utf-8", errors="replace", newline="") as file:
            text = file.read().replace("\r\n", "\n")
        shown = path if path.startswith(os.curdir) else os.path.join(os.curdir, path)
        found += [
            f"{shown}:{line}:{column}: {what}"
            for line, column, what in sorted({*_layout(text, longest), *_meaning(text)})
        ]
    return found


def _layout(text: str, longest: int) -> Iterator[tuple[int, int, str]]:
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        if len(line) > longest:
            yield number, longest + 1, f"E501 line too long ({len(line)} > {longest} characters)"
        if line[: len(line) - len(line.lstrip())].count("\t"):
            yield number, 1, "W191 indentation contains tabs"
        if line != line.rstrip():
            end = len(line.rstrip()) + 1
            yield number, end, "W291 trailing whitespace" if line.strip() else "W293 blank line contains whitespace"
    if text and not text.endswith("\n"):
        yield len(lines), len(lines[-1]) + 1, "W292 no newline at end of file"
    if text.endswith("\n\n"):
        yield len(text.rstrip("\n").split("\n")) + 1, 1, "W391 blank line at end of file"


def _meaning(text: str) -> Iterator[tuple[int, int, str]]:
    try:
        tree = ast.parse(text)
    except SyntaxError as error:
        yield error.lineno or 1, error.offset or 1, f"E999 {type(error).__name__}: {error.msg}"
        return
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    strings = {node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, str)}
    for node in tree.body:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            for alias in node.names:
                name = (alias.asname or alias.name).split(".")[0]
                if name != "*" and name not in used | strings:
                    whole = f"{node.module}.{alias.name}" if isinstance(node, ast.ImportFrom) else alias.name
                    yield node.lineno, 1, f"F401 '{whole}' imported but unused"
