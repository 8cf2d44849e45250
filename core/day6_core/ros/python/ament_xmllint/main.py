"""Checks that XML files are well-formed. (The schemas that a file names are on the network; they are not fetched.)"""

from __future__ import annotations

import os
import sys
from xml.parsers import expat

from ament_lint.files import files_below, parser_for


def main(argv: list[str] | None = None) -> int:
    """Check the given files and folders (by default the current one); returns 1 if one is invalid or there is none."""
    parser = parser_for("ament_xmllint", "Check that XML files are well-formed.")
    parser.add_argument("--extensions", nargs="*", default=["xml"], help="the endings of the files in folders")
    chosen = parser.parse_args(sys.argv[1:] if argv is None else argv)
    endings = tuple(f".{each}" for each in chosen.extensions)
    files = [path for path in files_below(chosen.paths, endings) if not {*chosen.exclude} & {*path.split(os.sep)}]
    if not files:
        print("No files found", file=sys.stderr)
        return 1
    invalid = 0
    for path in files:
        error = _error_in(path)
        name = os.path.relpath(path)
        if error:
            print(f"File '{name}' is invalid:\n{error}\n", file=sys.stderr)
            invalid += 1
        else:
            print(f"File '{name}' is valid\n")
    if invalid:
        print(f"{invalid} files are invalid", file=sys.stderr)
        return 1
    print("No problems found")
    return 0


def _error_in(path: str) -> str:
    parser = expat.ParserCreate()
    parser.DefaultHandler = lambda text: None  # with one, entities are not expanded
    try:
        with open(path, "rb") as file:
            parser.ParseFile(file)
    except expat.ExpatError as error:
        return f"{os.path.abspath(path)}:{error.lineno}: parser error : {expat.ErrorString(error.code)}"
    return ""
