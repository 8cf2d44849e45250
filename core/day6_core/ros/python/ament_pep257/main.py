"""Checks docstrings by those rules of PEP 257 that ROS requires. (A missing docstring is not an error.)"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator

from ament_lint.files import files_below


def main(argv: list[str] | None = None) -> int:
    """Check the given files and folders (by default the current one); returns 1 if there are errors."""
    count = 0
    for path in sorted(set(files_below(sys.argv[1:] if argv is None else argv, ".py"))):
        with open(path, encoding="utf-8", errors="replace") as file:
            for line, what in _errors(file.read()):
                print(f"{path}:{line}: {what}", file=sys.stderr)
                count += 1
    print(f"{count} errors" if count else "No problems found")
    return 1 if count else 0


def _errors(text: str) -> Iterator[tuple[int, str]]:
    try:
        tree = ast.parse(text)
    except SyntaxError:
        return  # ament_flake8 reports it
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            doc = ast.get_docstring(node, clean=False)
            if doc is not None:
                line = node.body[0].lineno
                source = ast.get_source_segment(text, node.body[0]) or ""
                is_function = isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
                yield from ((line, what) for what in _errors_of(doc, source, is_function))


def _errors_of(doc: str, source: str, is_function: bool) -> Iterator[str]:
    lines = doc.strip().splitlines()
    if not lines:
        yield "D419: Docstring is empty"
        return
    if not source.lstrip("rRuU").startswith('"""'):
        yield 'D300: Use """triple double quotes"""'
    if len(doc.splitlines()) == 1 and doc != doc.strip():
        yield "D210: No whitespaces allowed surrounding docstring text"
    if len(lines) > 1 and lines[1].strip():
        yield "D205: 1 blank line required between summary line and description"
    if not lines[0].rstrip().endswith("."):
        yield f"D400: First line should end with a period (not {lines[0].rstrip()[-1]!r})"
    first = lines[0].split()[0]
    if is_function and first.isalpha() and first[0].islower():
        yield f"D403: First word of the first line should be properly capitalized ({first.capitalize()!r}, not {first!r})"
