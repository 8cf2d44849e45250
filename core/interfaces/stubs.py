"""Type stubs (.pyi) of interface packages, for editors and type checkers: the classes themselves are made when first used.

An attribute reads as what it holds (`array.array` for a sequence of numbers, `numpy.ndarray` for a fixed array of them) and takes
any sequence, as the classes do.
"""

from __future__ import annotations

import re
from typing import Any

from day6_tui.core.interfaces.registry import get_action, get_message, get_service, interface_names

_PRIMITIVES = {
    "boolean": "bool",
    "octet": "bytes",
    "float": "float",
    "double": "float",
    "string": "str",
    "wstring": "str",
    **{f"{sign}int{bits}": "int" for sign in ("", "u") for bits in (8, 16, 32, 64)},
}
_NUMBERS = frozenset(name for name, python in _PRIMITIVES.items() if python in ("int", "float"))
_SEQUENCE = re.compile(r"sequence<(.+?)(?:, \d+)?>")
_ARRAY = re.compile(r"(.+)\[\d+\]")
_BOUND = re.compile(r"<\d+>")

_HEAD = """\
# Made by day6-tui from the interface texts; `day6-tui env` writes it anew.
import array
from collections.abc import Sequence
from typing import Any, ClassVar

import numpy
"""

Types = tuple[str, str]
"""What an attribute reads as, and what may be given to it."""


def package_stubs(package: str) -> dict[str, str]:
    """Return the files of a package's stubs: path below the stub folder -> text. Empty for a package without interfaces."""
    files: dict[str, str] = {}
    for kind, of in (("msg", _message), ("srv", _service), ("action", _action)):
        names = [name.partition("/")[2] for name in interface_names(package, kind)]
        if names:
            imports: set[str] = set()
            bodies = [of(package, name, imports) for name in names]
            lines = [f"import {module}" for module in sorted(imports - {f"{package}.{kind}"})]
            files[f"{package}/{kind}/__init__.pyi"] = "\n".join([_HEAD + "\n".join(lines), *bodies])
    if files:
        files[f"{package}/__init__.pyi"] = "".join(
            f"from {package} import {path.split('/')[1]} as {path.split('/')[1]}\n" for path in files
        )
    return files


def _message(package: str, name: str, imports: set[str]) -> str:
    return _class(get_message(f"{package}/msg/{name}"), name, f"{package}.msg", imports)


def _service(package: str, name: str, imports: set[str]) -> str:
    service = get_service(f"{package}/srv/{name}")
    return _service_class(service, name, f"{package}.srv", imports)


def _service_class(service: Any, name: str, module: str, imports: set[str]) -> str:
    parts = ("Request", "Response", "Event")
    classes = [_class(getattr(service, part), f"{name}_{part}", module, imports) for part in parts]
    lines = [f"class {name}:", *(f"    {part} = {name}_{part}" for part in parts), ""]
    return "\n".join([*classes, *lines])


def _action(package: str, name: str, imports: set[str]) -> str:
    action, module = get_action(f"{package}/action/{name}"), f"{package}.action"
    parts = ("Goal", "Result", "Feedback")
    classes = [_class(getattr(action, part), f"{name}_{part}", module, imports) for part in parts]
    lines = [f"class {name}:", *(f"    {part} = {name}_{part}" for part in parts), "    Impl: ClassVar[Any]", ""]
    return "\n".join([*classes, *lines])


def _class(cls: Any, name: str, module: str, imports: set[str]) -> str:
    """One class with fields: constants, a constructor by keywords, and a property for each field."""
    fields = {field: _types(text, module, imports) for field, text in cls.get_fields_and_field_types().items()}
    lines = [f"class {name}:"]
    for constant in sorted(each for each in {*dir(type(cls)), *vars(cls)} if _is_constant(each)):
        value = getattr(cls, constant)
        if isinstance(value, (bool, int, float, str, bytes)):
            lines.append(f"    {constant}: ClassVar[{type(value).__name__}]")
    keywords = "".join(f", {field}: {given} = ..." for field, (_, given) in fields.items())
    star = ", *" if fields else ""
    lines.append(
        f"    def __init__(self{star}{keywords}, check_fields: bool | None = ...) -> None: ..."
        if fields
        else "    def __init__(self) -> None: ..."
    )
    for field, (held, given) in fields.items():
        lines.append("    @property")
        lines.append(f"    def {field}(self) -> {held}: ...")
        lines.append(f"    @{field}.setter")
        lines.append(f"    def {field}(self, value: {given}) -> None: ...")
    lines.append("    @classmethod")
    lines.append("    def get_fields_and_field_types(cls) -> dict[str, str]: ...")
    lines.append("    SLOT_TYPES: ClassVar[tuple[Any, ...]]")
    return "\n".join([*lines, ""])


def _is_constant(name: str) -> bool:
    return name.isupper() and not name.startswith("_") and name != "SLOT_TYPES"


def _types(text: str, module: str, imports: set[str]) -> Types:
    """The types of a field from rosidl's text for it: 'sequence<double, 3>', 'geometry_msgs/Point', 'float[9]' …"""
    if found := _SEQUENCE.fullmatch(text):
        held, _ = _types(found[1], module, imports)
        if found[1] in _NUMBERS:
            return f"array.array[{held}]", f"Sequence[{held}] | array.array[{held}] | numpy.ndarray[Any, Any]"
        return f"list[{held}]", f"Sequence[{held}]"
    if found := _ARRAY.fullmatch(text):
        held, _ = _types(found[1], module, imports)
        if found[1] in _NUMBERS:
            return "numpy.ndarray[Any, Any]", f"Sequence[{held}] | numpy.ndarray[Any, Any]"
        return f"list[{held}]", f"Sequence[{held}]"
    text = _BOUND.sub("", text)
    if text in _PRIMITIVES:
        return (_PRIMITIVES[text],) * 2
    package, _, name = text.rpartition("/")
    # The events of a service hold its requests, which stand in its own module.
    kind = module.rpartition(".")[2] if name.endswith(("_Request", "_Response")) else "msg"
    home = f"{package.partition('/')[0]}.{kind}"
    if home == module:
        return name, name
    imports.add(home)
    return f"{home}.{name}", f"{home}.{name}"
