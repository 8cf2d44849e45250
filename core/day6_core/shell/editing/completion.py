"""What Tab offers in a Python file: modules after `import`, names after `from … import`, fields of a message after a dot.

The text is read by lines, because a program that is being typed seldom compiles. A variable's type counts as known where one
line says it: `msg = Twist()`, `msg: Twist`, or the callback that `create_subscription(Twist, …)` names.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from day6_core.advice import known

_MODULE = re.compile(r"\s*(?:import|from) ((?:\w+\.)*)(\w*)")
_NAME = re.compile(r"\s*from ([\w.]+) import \(?(?:\w+\s*,\s*)*(\w*)")
_FIELD = re.compile(r".*?((?:self\.)?\b[A-Za-z_]\w*)((?:\.\w+)*)\.(\w*)")
_IMPORTED = re.compile(r"^\s*from (\w+)\.(msg|srv|action) import (.+)$", re.MULTILINE)
_DEF = re.compile(r"^(\s*)def (\w+)\((.*)")


def completions(text: str, row: int, column: int, variables: Mapping[str, str], folder: Path) -> tuple[list[str], int]:
    """Return what could stand before the cursor (sorted) and the column where that word begins; ([], column) if nothing is known.

    `folder` is that of the file, whose modules can be imported too.
    """
    lines = text.split("\n")
    before = lines[row][:column]
    if found := _NAME.fullmatch(before):
        return _beginning(found[2], known.names_of(found[1], _with(folder, variables)), column)
    if found := _MODULE.fullmatch(before):
        outer = found[1].rstrip(".")
        places = _with(folder, variables)
        return _beginning(found[2], known.parts_of(outer, places) if outer else known.modules(places), column)
    if found := _FIELD.fullmatch(before):
        whole = _type_of(found[1], lines, row, variables)
        for name in found[2].split(".")[1:]:
            whole = known.layout_of(whole, variables).get(name, "")
        return _beginning(found[3], list(known.layout_of(whole, variables)), column)
    return [], column


def _beginning(typed: str, names: list[str], column: int) -> tuple[list[str], int]:
    return sorted({name for name in names if name.startswith(typed)}), column - len(typed)


def _with(folder: Path, variables: Mapping[str, str]) -> dict[str, str]:
    return {**variables, "PYTHONPATH": f"{folder}{known.SEPARATOR}{variables.get('PYTHONPATH', '')}"}


def _type_of(variable: str, lines: list[str], row: int, variables: Mapping[str, str]) -> str:
    """Return the message type of a variable of the function that a line is in, '' if no line says it, or two differ."""
    types = _imported_types("\n".join(lines))
    made = re.compile(rf"\s*{re.escape(variable)}\s*(?::\s*(\w+)\s*)?(?:=\s*(\w+)\(|=|$)")
    if variable.startswith("self."):
        found = {types.get(match[1] or match[2] or "", "") for line in lines if (match := made.match(line))}
        return found.pop() if len(found) == 1 else ""
    for at in range(row - 1, -1, -1):
        line = lines[at]
        if match := made.match(line):
            return types.get(match[1] or match[2] or "", "")
        if match := _DEF.match(line):
            return _of_parameter(variable, match[2], match[3], lines, types)
    return ""


def _of_parameter(variable: str, function: str, parameters: str, lines: list[str], types: Mapping[str, str]) -> str:
    if match := re.search(rf"\b{re.escape(variable)}\s*:\s*(\w+)", parameters):
        return types.get(match[1], "")
    if not re.search(rf"\b{re.escape(variable)}\b", parameters):
        return ""
    subscribed = re.compile(rf"create_subscription\(\s*(\w+)\s*,[^()]*?\b(?:self\.)?{re.escape(function)}\b")
    found = {types.get(name, "") for name in subscribed.findall("\n".join(lines))}
    return found.pop() if len(found) == 1 else ""


def _imported_types(text: str) -> dict[str, str]:
    """Return the full names of the types that a program imports, by the names it gives them."""
    found = {}
    for package, kind, names in _IMPORTED.findall(text):
        for each in names.partition("#")[0].strip(" ()").split(","):
            name, _, other = each.strip().partition(" as ")
            found[other.strip() or name] = f"{package}/{kind}/{name}"
    return found
