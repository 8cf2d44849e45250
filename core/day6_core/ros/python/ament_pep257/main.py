"""Checks docstrings by those rules of PEP 257 that ROS requires. (A missing docstring is not an error.)

It is done by pydocstyle, as in ROS, or where that is not installed by ourselves, without the rules on words and sections.
"""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Iterator, Set
from importlib import import_module
from importlib.util import find_spec

from ament_lint.files import files_below, parser_for

_OURS = {"D200", "D205", "D209", "D210", "D213", "D300", "D400", "D403", "D419"}
_NOT_IN = {
    "ament": "100 101 102 103 104 105 106 107 203 212 404",
    "google": "203 204 213 215 400 401 404 406 407 408 409 413",
    "numpy": "107 203 212 213 402 413 415 416 417",
    "pep257": "203 212 213 214 215 404 405 406 407 408 409 410 411 413 415 416 417 418",
}
"""What each convention leaves out."""


def main(argv: list[str] | None = None) -> int:
    """Check the given files and folders (by default the current one); returns 1 if there are errors."""
    parser = parser_for("ament_pep257", "Check docstrings by PEP 257.")
    codes = parser.add_mutually_exclusive_group()
    codes.add_argument("--ignore", nargs="+", default=[], help="check all but these codes")
    codes.add_argument("--select", nargs="+", default=[], help="check these codes only")
    codes.add_argument("--convention", choices=sorted(_NOT_IN), default="ament", help="check a set of codes")
    parser.add_argument("--add-ignore", nargs="+", default=[], help="do not check these codes either")
    parser.add_argument("--add-select", nargs="+", default=[], help="check these codes, too")
    chosen = parser.parse_args(sys.argv[1:] if argv is None else argv)
    left_out = [os.path.abspath(path) for path in chosen.exclude]
    files = [
        path
        for path in sorted({*files_below(chosen.paths, ".py")})
        if not any((os.path.abspath(path) + os.sep).startswith(each + os.sep) for each in left_out)
    ]
    ignored = {*chosen.ignore} or {f"D{number}" for number in _NOT_IN[chosen.convention].split()}
    by_pydocstyle = find_spec("pydocstyle") is not None
    known = import_module("pydocstyle.violations").ErrorRegistry.get_error_codes() if by_pydocstyle else _OURS
    checked = ({*chosen.select} or {*known} - ignored) | {*chosen.add_select}
    errors = (_by_pydocstyle if by_pydocstyle else _by_ourselves)(files, checked - {*chosen.add_ignore})
    for error in errors:
        print(error, file=sys.stderr)
    print(f"{len(errors)} errors" if errors else "No problems found")
    return 1 if errors else 0


def _by_pydocstyle(files: list[str], checked: Set[str]) -> list[str]:
    found = import_module("pydocstyle").check(files, select=checked)
    # a file that cannot be read or parsed gives an exception in place of what is wrong with a docstring
    return [f"{each.filename}:{each.line}: {each.message}" if hasattr(each, "message") else str(each) for each in found]


def _by_ourselves(files: list[str], checked: Set[str]) -> list[str]:
    found = []
    for path in files:
        with open(path, encoding="utf-8", errors="replace") as file:
            errors = _errors(file.read())
        found += [f"{path}:{line}: {what}" for line, what in errors if what.partition(":")[0] in checked]
    return found


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
    written = doc.splitlines()
    if len(written) == 1 and doc != doc.strip():
        yield "D210: No whitespaces allowed surrounding docstring text"
    if len(lines) == 1 and len(written) > 1:
        yield "D200: One-line docstring should fit on one line with quotes"
    if len(lines) > 1:
        if written[0].strip():
            yield "D213: Multi-line docstring summary should start at the second line"
        if lines[1].strip():
            yield "D205: 1 blank line required between summary line and description"
        if written[-1].strip():
            yield "D209: Multi-line docstring closing quotes should be on a separate line"
    if not lines[0].rstrip().endswith("."):
        yield f"D400: First line should end with a period (not {lines[0].rstrip()[-1]!r})"
    first = lines[0].split()[0]
    if is_function and first.isalpha() and first[0].islower():
        yield f"D403: First word of the first line should be properly capitalized ({first.capitalize()!r}, not {first!r})"
