"""Changes Python's modules when they are imported, so that a program pays only for those that it uses."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import os
from collections.abc import Callable
from typing import Any

_LIBRARY = os.path.join(os.path.dirname(os.__file__), "")
_calls: dict[str, list[Callable[[Any], None]]] = {}


def when_imported(name: str, call: Callable[[Any], None]) -> None:
    """Call with a module of Python's once it has been imported, which may be now."""
    module = sys.modules.get(name)
    if module is not None:
        call(module)
        return
    if not _calls:
        sys.meta_path.insert(0, _Finder)
    _calls.setdefault(name, []).append(call)


def found_by_others(asking: Any, name: str, path: Any, target: Any) -> Any:
    """Return the spec that the first of the other finders finds, None if none does."""
    for finder in sys.meta_path:
        if finder is not asking:
            spec: Any = finder.find_spec(name, path, target)
            if spec is not None:
                return spec
    return None


class _Finder:
    @staticmethod
    def find_spec(name: str, path: Any = None, target: Any = None) -> Any:
        if name not in _calls:
            return None
        spec = found_by_others(_Finder, name, path, target)
        if spec is None or spec.loader is None:
            return spec
        if not spec.has_location or spec.origin.startswith(_LIBRARY):
            spec.loader = _Loader(spec.loader, name)
        return spec


class _Loader:
    def __init__(self, loader: Any, name: str) -> None:
        self._loader = loader
        self._name = name

    def __getattr__(self, name: str) -> Any:
        return getattr(self._loader, name)

    def create_module(self, spec: Any) -> Any:
        return self._loader.create_module(spec)

    def exec_module(self, module: Any) -> None:
        module.__loader__ = module.__spec__.loader = self._loader
        self._loader.exec_module(module)
        for call in _calls.pop(self._name, ()):
            call(module)
