"""What the pupil's file shows about a name that Python does not find, or about `main`.

A name is written without self, used before it has a value, or a class is used without (); main is never called.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from day6_core.advice.callbacks import Cause, parsed
from day6_core.advice.fault import Fault
from day6_core.facts.names import CLOSE, nearest

_A_CLASS = re.compile(r"'property' object|type object '|positional argument: 'self'|Metaclass_")
"""What Python says when a class is used where an object is meant."""


_OF_NODES = frozenset(
    [
        "create_publisher",
        "create_subscription",
        "create_timer",
        "create_service",
        "create_client",
        "create_rate",
        "get_logger",
        "get_clock",
        "get_parameter",
        "declare_parameter",
    ]
)
"""Methods of a node that programs call on themselves."""


def cause_of_name(fault: Fault, cwd: Path) -> Cause | None:
    """Return what the pupil's file shows to be the cause of an exception, None if that is not certain."""
    tree = parsed(cwd / fault.file) if fault.file else None
    if tree is None:
        return None
    if (unknown := re.match(r"name '(\w+)' is not defined", fault.message)) is not None:
        right = f"self.{unknown[1]}"
        belongs = unknown[1] in _of_self(tree) or unknown[1] in _OF_NODES
        return ("self.lacks", {"line": fault.line, "right": right}) if belongs else None
    if fault.kind == "UnboundLocalError" and (local := re.search(r"local variable '(\w+)'", fault.message)) is not None:
        return _unbound(tree, local[1], fault.line)
    if (lacks := re.match(r"'(\w+)' object has no attribute '(\w+)'", fault.message)) is not None:
        later = _of_self(tree, lacks[1]).get(lacks[2], 0)
        values = {"line": fault.line, "name": lacks[2], "later": later}
        if later:
            return "self.later", values
        outside = next(_methods_outside(tree, lacks[2]), None)
        if outside is not None:
            return "method.outside", {"line": outside.lineno, "name": outside.name, "kind": lacks[1]}
    if (undeclared := re.search(r"undeclared parameter\(s\): (\S+)$", fault.message)) is not None:
        near = nearest(undeclared[1], list(_declared(tree)), CLOSE)
        return ("parameter.near", {"name": undeclared[1], "near": near}) if near else None
    return _class_for_object(tree, fault) if _A_CLASS.search(fault.message) else None


def _unbound(tree: ast.Module, name: str, line: int) -> Cause | None:
    """Whether a name without a value belongs to the whole file, or gets its value only later in the function."""
    if any(name in _given(each) for each in tree.body if isinstance(each, ast.Assign | ast.AnnAssign)):
        return "local.outside", {"line": line, "name": name}
    functions = [each for each in ast.walk(tree) if isinstance(each, ast.FunctionDef) and line in _lines(each)]
    inner = ast.walk(functions[-1]) if functions else ()
    later = [each.lineno for each in inner if isinstance(each, ast.stmt) and name in _given(each)]
    after = [number for number in later if number > line]
    return ("local.later", {"line": line, "name": name, "later": after[0]}) if after == later and after else None


def _given(node: ast.AST) -> set[str]:
    """The names that a statement gives a value."""
    targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AnnAssign) else []
    return {each.id for each in targets if isinstance(each, ast.Name)}


def _lines(function: ast.FunctionDef) -> range:
    return range(function.lineno, (function.end_lineno or function.lineno) + 1)


def _of_self(tree: ast.Module, owner: str = "") -> dict[str, int]:
    """What belongs to the classes of a file, or to one: a variable with the line that gives it a value, a method with 0."""
    found: dict[str, int] = {}
    for each in ast.walk(tree):
        if isinstance(each, ast.ClassDef) and owner in ("", each.name):
            found |= {inner.name: 0 for inner in each.body if isinstance(inner, ast.FunctionDef)}
            for node in ast.walk(each):
                if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and _is_self(node.value):
                    found.setdefault(node.attr, node.lineno)
    return found


def _methods_outside(tree: ast.Module, name: str) -> Iterator[ast.FunctionDef]:
    """Functions of the file that take self, and that are or have within them the one of that name: their indentation is lost."""
    methods = (each for each in tree.body if isinstance(each, ast.FunctionDef))
    for each in methods:
        inner = {node.name for node in ast.walk(each) if isinstance(node, ast.FunctionDef)}
        if [arg.arg for arg in each.args.args][:1] == ["self"] and name in inner:
            yield each


def _is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id == "self"


def _declared(tree: ast.Module) -> Iterator[str]:
    """The parameters that a file declares by their names."""
    for node in ast.walk(tree):
        called = node.func if isinstance(node, ast.Call) else None
        if isinstance(node, ast.Call) and isinstance(called, ast.Attribute) and called.attr == "declare_parameter":
            yield from (
                each.value for each in node.args[:1] if isinstance(each, ast.Constant) and isinstance(each.value, str)
            )


def _class_for_object(tree: ast.Module, fault: Fault) -> Cause | None:
    """The one variable of the line that failed to which a class was given, and not an object."""
    classes = {node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef)}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            classes |= {each.asname or each.name for each in node.names if each.name[:1].isupper()}
    words = set(re.findall(r"\w+", fault.source))
    found = [
        (node.lineno, target.id, node.value.id)
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Name) and node.value.id in classes
        for target in node.targets
        if isinstance(target, ast.Name) and target.id in words
    ]
    if len(found) != 1:
        return None
    ((line, name, kind),) = found
    return "class.no_brackets", {"line": line, "name": kind, "right": f"{name} = {kind}()"}


def _does_something(statement: ast.stmt) -> bool:
    """Whether a statement of a file does more than define, import and name things, or ask for `__name__`."""
    if isinstance(statement, ast.Expr):
        return not isinstance(statement.value, ast.Constant | ast.Name)
    if isinstance(statement, ast.If):
        return "__name__" not in ast.unparse(statement.test)
    defines = (
        ast.FunctionDef,
        ast.AsyncFunctionDef,
        ast.ClassDef,
        ast.Import,
        ast.ImportFrom,
        ast.Assign,
        ast.AnnAssign,
    )
    return not isinstance(statement, defines)


def never_begun(path: Path) -> Cause | None:
    """Return why a program that did nothing at all did nothing: its `main` is called nowhere, or under a condition never true."""
    tree = parsed(path)
    mains = [each for each in tree.body if isinstance(each, ast.FunctionDef) and each.name == "main"] if tree else []
    if tree is None or not mains or any(map(_does_something, tree.body)):
        return None
    for each in tree.body:
        asks = ast.unparse(each.test) if isinstance(each, ast.If) else ""
        if (asked := re.fullmatch(r"__name__ == '(\w+)'", asks)) is not None and asked[1] != "__main__":
            return "main.other_name", {"line": each.lineno}
    called = any(
        isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "main"
        for each in tree.body
        for node in ast.walk(each)
    )
    return None if called else ("main.never_called", {"line": mains[0].lineno})
