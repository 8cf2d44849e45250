"""The public names of rclpy: modules, classes, members, signatures; of a real one and of ours.

    python -m tests.conformance.names [--real PATH-TO-PYTHON] [--record]

prints what ours lacks or has with other arguments, compared with what is recorded in tests/rclpy/names.json or, with
`--real`, with that rclpy (`--record`: and writes it down). Only the standard library is used before an rclpy is looked at,
because the same file runs in both.
"""

from __future__ import annotations

import argparse
import importlib
import inspect
import json
import pkgutil
import subprocess
import sys
from collections.abc import Mapping
from enum import Enum
from pathlib import Path
from typing import Any, Union, get_origin

RECORDED = Path(__file__).resolve().parents[1] / "rclpy" / "names.json"
_OPERATORS = "eq ne lt le gt ge add radd sub mul rmul truediv neg iadd hash str repr"
_DUNDERS = frozenset(f"__{name}__" for name in f"init enter exit call await {_OPERATORS}".split())
_INCIDENTAL = frozenset(("TYPE_CHECKING", "g_logging_ref_count"))
"""What modules have by the way of writing them."""
_OWN_INIT_UNCHECKED = frozenset(("rclpy.clock.Clock", "rclpy.clock.ROSClock"))
"""Classes whose arguments are those of `__new__`."""

Table = dict[str, dict[str, dict[str, Any]]]


def collect() -> Table:
    """Describe everything public of the rclpy that can be imported here: module -> name -> description."""
    import rclpy

    found: Table = {}
    for info in pkgutil.walk_packages(rclpy.__path__, "rclpy."):
        if not any(part.startswith("_") for part in info.name.split(".")) and "test" not in info.name:
            importlib.import_module(info.name)
    modules = [name for name in sys.modules if name == "rclpy" or name.startswith("rclpy.")]
    for name in sorted(modules):
        if not any(part.startswith("_") for part in name.split(".")):
            module = sys.modules[name]
            found[name] = {
                attribute: describe(value, elsewhere=getattr(value, "__module__", name) in set(modules) - {name})
                for attribute, value in sorted(vars(module).items())
                if not attribute.startswith("_") and attribute not in _INCIDENTAL and _is_rclpys(value)
            }
    return found


def _is_rclpys(value: Any) -> bool:
    if inspect.ismodule(value):
        return False
    if inspect.isclass(value) or inspect.isroutine(value):
        return str(value.__module__).split(".")[0] == "rclpy"
    return isinstance(value, (int, float, str)) or type(value).__module__.split(".")[0] == "rclpy"


def describe(value: Any, *, elsewhere: bool = False) -> dict[str, Any]:
    """Describe one thing: its kind, its arguments, and for a class its members (unless that is done elsewhere)."""
    if inspect.isclass(value) and elsewhere:
        return {"kind": "class"}
    if inspect.isclass(value):
        described: dict[str, Any] = {"kind": "class", "members": _members(value)}
        if issubclass(value, BaseException):
            described["bases"] = [each.__name__ for each in value.__mro__[1:-1] if each.__module__ != "builtins"]
        choices = getattr(value, "__members__", None)
        if isinstance(choices, Mapping):
            described["values"] = {name: each.value for name, each in choices.items() if _plain(each.value)}
            for name in ("name", "value"):
                described["members"].pop(name, None)
        return described
    if callable(value):
        return {"kind": "function", "arguments": arguments(value)}
    return {"kind": "value", "value": value} if _plain(value) else {"kind": "value"}


def _plain(value: Any) -> bool:
    return isinstance(value, (int, float, str)) and not isinstance(value, Enum)


def _members(cls: type) -> dict[str, Any]:
    names = {
        name
        for each in cls.__mro__
        if each.__module__.split(".")[0] == "rclpy"
        for name in vars(each)
        if not name.startswith("_") or name in _DUNDERS
    }
    described = {name: _member(cls, name) for name in sorted(names)}
    return {name: each for name, each in described.items() if each is not None}


def _member(cls: type, name: str) -> Any:
    value = inspect.getattr_static(cls, name)
    if isinstance(value, (staticmethod, classmethod)):
        value = value.__func__
    if inspect.isclass(value):
        # A class that was only imported inside another is no part of it.
        return "class" if value.__qualname__.startswith(f"{cls.__qualname__}.") else None
    if inspect.isfunction(value):
        return arguments(value)
    # A union of types can be called before Python 3.14, to no purpose.
    return "callable" if callable(value) and get_origin(value) is not Union else "attribute"


def arguments(function: Any) -> list[str] | None:
    """Return the arguments as texts (`name`, `*`, `name=None`, `**kwargs`); None where nothing tells them."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return None
    texts: list[str] = []
    starred = False
    for parameter in signature.parameters.values():
        if parameter.kind is parameter.KEYWORD_ONLY and not starred:
            texts.append("*")
            starred = True
        prefix = {parameter.VAR_POSITIONAL: "*", parameter.VAR_KEYWORD: "**"}.get(parameter.kind, "")
        starred = starred or prefix == "*"
        default = ""
        if parameter.default is not parameter.empty:
            plain = parameter.default is None or _plain(parameter.default)
            default = f"={parameter.default!r}" if plain else "=…"
        texts.append(f"{prefix}{parameter.name}{default}")
    return texts


def differences(wanted: Table) -> list[str]:
    """Compare what can be imported here with a table; returns a line for everything that is missing or different."""
    found: list[str] = []
    for module_name, names in wanted.items():
        try:
            module = importlib.import_module(module_name)
        except ImportError as error:
            found.append(f"{module_name}: {error}")
            continue
        for name, description in names.items():
            full = f"{module_name}.{name}"
            try:
                value = getattr(module, name)
            except AttributeError:
                found.append(f"{full}: missing")
                continue
            found += _compare(full, description, describe(value))
    return found


def _compare(full: str, wanted: dict[str, Any], found: dict[str, Any]) -> list[str]:
    lines: list[str] = []
    if wanted["kind"] != found["kind"]:
        return [f"{full}: a {wanted['kind']}, here a {found['kind']}"]
    for key in ("value", "values", "bases"):
        if key in wanted and wanted[key] != found.get(key):
            lines.append(f"{full}: {key} {wanted[key]}, here {found.get(key)}")
    if wanted.get("arguments") and wanted["arguments"] != found.get("arguments"):
        lines.append(f"{full}({', '.join(wanted['arguments'])}), here ({', '.join(found.get('arguments') or ())})")
    for name, member in wanted.get("members", {}).items():
        own = found.get("members", {}).get(name)
        if own is None and name not in found.get("members", {}):
            if name not in _DUNDERS:
                lines.append(f"{full}.{name}: missing")
        elif isinstance(member, list) and isinstance(own, list):
            if member[1:] not in (own[1:], ["*args", "**kwargs"]) and not (
                name == "__init__" and full in _OWN_INIT_UNCHECKED
            ):
                lines.append(f"{full}.{name}({', '.join(member)}), here ({', '.join(own)})")
        elif (member == "attribute") != (own == "attribute"):
            lines.append(f"{full}.{name}: {'no ' if member == 'attribute' else 'a '}method, here the other way round")
    return lines


def of_real(python: str) -> Table:
    """Have the rclpy of another interpreter described."""
    done = subprocess.run([python, __file__, "--collect"], capture_output=True, text=True, check=True, cwd="/")
    table: Table = json.loads(done.stdout)
    return table


def main() -> int:
    """Print the differences; the status says whether there are any."""
    parser = argparse.ArgumentParser(description="Compares the public names of rclpy.")
    parser.add_argument("--real", help="a Python interpreter that can import a real rclpy")
    parser.add_argument("--record", action="store_true", help="write down the real one's names")
    parser.add_argument("--collect", action="store_true", help=argparse.SUPPRESS)
    chosen = parser.parse_args()
    if chosen.collect:
        json.dump(collect(), sys.stdout)
        return 0
    wanted: Table = of_real(chosen.real) if chosen.real else json.loads(RECORDED.read_text(encoding="utf-8"))
    if chosen.record:
        lines = [f"{json.dumps(name)}: {json.dumps(wanted[name], sort_keys=True)}" for name in sorted(wanted)]
        RECORDED.write_text("{" + ",\n".join(lines) + "}\n", encoding="utf-8")
    from day6_core.ros import environment

    environment.activate()
    lines = differences(wanted)
    print("\n".join(lines))
    count = sum(1 + len(each.get("members", ())) for names in wanted.values() for each in names.values())
    print(f"{len(lines)} differences in {count} names of {len(wanted)} modules")
    return bool(lines)


if __name__ == "__main__":
    raise SystemExit(main())
