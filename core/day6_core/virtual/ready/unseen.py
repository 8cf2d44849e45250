"""Modules that are imported already but that nobody sees, in this process and its forks, before they are imported once more.

Then they are looked for as ever, and only if the same file is found, it is the module that is there. So a program has to import
what it uses, and its own file that has the name of one of Python's modules is found as in any other interpreter.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import builtins
import ctypes
import os
import subprocess
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

from day6_core.virtual import surroundings
from day6_core.virtual.follow.imports import found_by_others

_seen: frozenset[str] = frozenset()
_imports: dict[str, dict[str, None]] = {}
"""By module: those that it imports when it is imported itself."""
_unseen: dict[str, ModuleType] = {}
_shared: dict[str, ModuleType] = {}
"""The same, but also those that somebody sees meanwhile."""
ctypes.pythonapi.Py_IncRef(ctypes.py_object(_shared))  # which will never be taken apart
_places: list[tuple[dict[str, Any], str, ModuleType]] = []
"""Where packages had them: the names of the package, and the module's own there."""
_real_import = builtins.__import__


def begin() -> None:
    """Look what a new interpreter in virtual time has imported that runs nothing. From now on, note what modules import."""
    global _seen
    env = {**surroundings.environment(os.environ), surroundings.VARIABLE: ""}
    told = "import sys, day6_core.virtual.follow\nprint(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", told], env=env, stdout=subprocess.PIPE, check=True)
    _seen = frozenset(done.stdout.decode().split())
    builtins.__import__ = _import_and_note


def hide() -> None:
    """Have nobody see anything else of what is imported so far."""
    builtins.__import__ = _real_import
    for name, module in list(sys.modules.items()):
        if name in _seen or getattr(module, "__spec__", None) is None:
            continue
        _unseen[name] = sys.modules.pop(name)
    for name, module in _unseen.items():
        in_package, last = _place_of(name)
        if in_package.get(last) is module:
            _places.append((in_package, last, module))
            del in_package[last]
    _shared.update(_unseen)
    sys.meta_path.insert(0, _Finder)


def hide_again() -> None:
    """Hide what was seen once more since then."""
    for name in [each for each in sys.modules if each not in _seen]:
        if sys.modules[name] is _shared.get(name):
            _unseen[name] = sys.modules.pop(name)


def give_back() -> None:
    """Have packages have what is hidden. For a fork that goes on with modules that use such a package."""
    for in_package, last, module in _places:
        in_package.setdefault(last, module)


def names() -> set[str]:
    """Return the names of all that is imported but for what is in packages, and of what Python imports by itself at its start."""
    found = {name.partition(".")[0] for name in (*sys.modules, *_shared)} - {"__main__"}
    return found | {"sitecustomize", "usercustomize"}


def last_seen() -> ModuleType:
    """Return the last of the modules that every interpreter has, which is taken apart first of these."""
    return sys.modules[next(name for name in reversed(sys.modules) if name in _seen)]


def forget() -> None:
    """At the end of such a fork: have Python not take apart what it shares with others."""
    for name, module in _shared.items():
        if sys.modules.get(name) is module:
            del sys.modules[name]


def _import_and_note(name: str, globals: Any = None, locals: Any = None, fromlist: Any = (), level: int = 0) -> Any:  # noqa: A002
    module = _real_import(name, globals, locals, fromlist, level)
    spec: Any = globals and globals.get("__spec__")
    if spec is not None and getattr(spec, "_initializing", False):
        if level:
            package = globals["__package__"].rsplit(".", level - 1)[0]
            name = f"{package}.{name}" if name else package
        noted = _imports.setdefault(spec.name, {})
        noted[name] = None
        noted.update({found: None for each in fromlist or () if (found := f"{name}.{each}") in sys.modules})
    return module


def _show(name: str) -> None:
    """Have a module seen, and what is imported with it."""
    waiting = [name]
    for each in waiting:
        if each in _unseen:
            module = sys.modules[each] = _unseen.pop(each)
            in_package, last = _place_of(each)
            in_package.setdefault(last, module)
            waiting += _imports.get(each, ())
        if "." in each:
            waiting.append(each.rpartition(".")[0])


def _place_of(name: str) -> tuple[dict[str, Any], str]:
    """The names of the package that a module is in, and its own there."""
    package, _, last = name.rpartition(".")
    found = _unseen.get(package) or sys.modules.get(package)
    return ({} if found is None else vars(found)), last


class _Finder:
    @staticmethod
    def find_spec(name: str, path: Any = None, target: Any = None) -> Any:
        if name not in _unseen:
            return None
        spec = found_by_others(_Finder, name, path, target)
        module = _unseen[name]
        was: Any = module.__spec__
        if spec is not None and spec.origin == was.origin:
            spec.loader = _Loader(module)
        else:
            del _unseen[name]
        return spec


class _Loader:
    """Gives the module that is there."""

    def __init__(self, module: ModuleType) -> None:
        self._module, self._spec = module, module.__spec__

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        return self._module

    def exec_module(self, module: ModuleType) -> None:
        module.__spec__ = self._spec
        if self._spec is not None:
            _show(self._spec.name)
