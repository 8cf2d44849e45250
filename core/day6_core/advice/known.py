"""What there is that a wrong name could have meant: modules, packages of the workspace, types of messages and their fields."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

from day6_core.facts.workspaces import sourced_prefixes
from day6_core.interfaces.definition import (
    InvalidSpecification,
    Structure,
    parse_action,
    parse_message,
    parse_service,
)
from day6_core.interfaces.fields import SINGLE
from day6_core.interfaces.values import InvalidValue
from day6_core.ros.differences import has_interface, path_of
from day6_core.ros.environment import SHARE_PATH, python_folders

SEPARATOR = os.pathsep

_PUBLIC = re.compile(r"^(?:class|def) ([A-Za-z]\w*)|^from \S+ import (.+)$", re.MULTILINE)


def modules(variables: Mapping[str, str]) -> list[str]:
    """Return the names of all modules that a program can import."""
    found = set(sys.stdlib_module_names)
    for folder in [*_python_path(variables), *map(Path, sys.path)]:
        found.update(_modules_in(folder))
    return sorted(found)


def parts_of(module: str, variables: Mapping[str, str]) -> list[str]:
    """Return the modules in a package: 'msg' and 'srv' of 'std_srvs'."""
    return sorted({name for folder in _folders_of(module, variables) for name in _modules_in(folder)})


def names_of(module: str, variables: Mapping[str, str]) -> list[str]:
    """Return what can be imported from a module: its types where it is one of messages, else its classes and functions."""
    package, _, kind = module.partition(".")
    if kind in ("msg", "srv", "action"):
        found = {path.stem for share in shares(variables) for path in (share / package / kind).glob(f"*.{kind}")}
        return sorted(name for name in found if has_interface(f"{module.replace('.', '/')}/{name}"))
    found = set(parts_of(module, variables))
    for folder in _folders_of(module, variables):
        for path in (folder / "__init__.py", folder.with_suffix(".py")):
            if path.is_file():
                for own, others in _PUBLIC.findall(path.read_text(encoding="utf-8", errors="replace")):
                    if own:
                        found.add(own)
                    elif path.name == "__init__.py":  # elsewhere an import is no offer
                        found.update(re.findall(r"[A-Za-z]\w*", others))
    return sorted(found - {"annotations", "TYPE_CHECKING"})


def types_called(name: str, variables: Mapping[str, str]) -> list[str]:
    """Return the interfaces of that name: ['std_msgs/msg/String']."""
    found = []
    for share in shares(variables):
        for kind in ("msg", "srv", "action"):
            found += [f"{path.parent.parent.name}/{kind}/{name}" for path in share.glob(f"*/{kind}/{name}.{kind}")]
    return sorted(filter(has_interface, set(found)))


def fields_of(name: str, variables: Mapping[str, str]) -> list[tuple[str, list[str]]]:
    """Return the messages with this class name, each with its fields; those of different packages may be alike."""
    messages = [whole for whole in types_called(name, variables) if "/msg/" in whole]
    structures = [(whole, _structure(whole, variables)) for whole in messages]
    return [(whole, [field.name for field in structure.fields]) for whole, structure in structures if structure]


def layout_of(whole: str, variables: Mapping[str, str]) -> dict[str, str]:
    """Return the fields of 'geometry_msgs/msg/Twist', each with its type ('' for a list); empty for an unknown message."""
    structure = _structure(whole, variables) if whole.count("/") == 2 else None
    if structure is None:
        return {}
    return {field.name: field.type.base if field.type.count == SINGLE else "" for field in structure.fields}


def sent_layout(whole: str, variables: Mapping[str, str]) -> dict[str, str]:
    """Return the fields of what is sent with this type: of a message, of the request of a service, of the goal of an action."""
    if whole.count("/") != 2:
        return {}
    structure = _structure(whole, variables, sent=True)
    if structure is None:
        return {}
    return {field.name: field.type.base if field.type.count == SINGLE else "" for field in structure.fields}


def template_of(whole: str, variables: Mapping[str, str], deepest: int = 3) -> str:
    """Return contents of that type with a nought for each field, as YAML: `{x: 0.0, name: ''}`; '' for one without fields."""
    return _template(sent_layout(whole, variables), variables, deepest)


def _template(layout: Mapping[str, str], variables: Mapping[str, str], deepest: int) -> str:
    values = []
    for name, base in layout.items():
        if base.count("/") == 2:
            inner = _template(layout_of(base, variables), variables, deepest - 1) if deepest else ""
            values.append(f"{name}: {inner or '{}'}")
        else:
            values.append(f"{name}: {_NOUGHTS.get(base, '0')}")
    return f"{{{', '.join(values)}}}" if values else ""


_NOUGHTS = {"bool": "false", "float32": "0.0", "float64": "0.0", "string": "''", "wstring": "''", "": "[]"}


def _structure(whole: str, variables: Mapping[str, str], *, sent: bool = False) -> Structure | None:
    package, kind, name = whole.split("/")
    for share in shares(variables):
        usual = share / package / kind / f"{name}.{kind}"
        path = Path(path_of(whole, str(share))) if share == SHARE_PATH else usual
        if path.is_file():
            try:
                text = path.read_text(encoding="utf-8", errors="replace")
                if sent and kind in ("srv", "action"):
                    return (parse_service if kind == "srv" else parse_action)(package, kind, name, text)[0]
                return parse_message(package, kind, name, text)
            except (InvalidSpecification, InvalidValue, ValueError, NameError, TypeError):
                return None  # the build says what is wrong with it
    return None


def shares(variables: Mapping[str, str]) -> Iterator[Path]:
    """Yield the folders in which a terminal with these variables finds packages."""
    yield SHARE_PATH
    yield from (prefix / "share" for prefix in sourced_prefixes(variables))


def _python_path(variables: Mapping[str, str]) -> Iterator[Path]:
    yield from map(Path, python_folders())
    yield from (Path(entry) for entry in variables.get("PYTHONPATH", "").split(os.pathsep) if entry)


def _folders_of(module: str, variables: Mapping[str, str]) -> Iterator[Path]:
    """The folders a package may be in, without importing it."""
    for folder in _python_path(variables):
        yield folder.joinpath(*module.split("."))


def _modules_in(folder: Path) -> set[str]:
    try:
        entries = list(os.scandir(folder))
    except OSError:
        return set()
    return {
        stem
        for entry in entries
        if (stem := entry.name.partition(".")[0]).isidentifier()
        and not stem.startswith("_")
        and (entry.name.endswith((".py", ".so", ".pyd")) or (entry.is_dir() and "." not in entry.name))
    }
