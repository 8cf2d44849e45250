"""Functions for the `__init__` files of message packages, so that `from std_msgs.msg import String` works lazily."""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec

from day6_core.interfaces import registry
from day6_core.interfaces.generate import module_name
from day6_core.ros import differences

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence
    from types import ModuleType
    from typing import Any

_WORDS = {"msg": "Message", "srv": "Service", "action": "Action"}
_PACKAGE_FILE = '''"""The ROS package {package}; its interface texts are in share/{package}."""
'''
_KIND_FILE = '''"""{word} classes of {package}, each made when first used."""

from day6_core.interfaces.package import lazy_interfaces

__getattr__, __dir__ = lazy_interfaces(__name__)
'''

# The names `from package.srv import *` gives besides the interface itself, as in the real packages' __init__ files.
_EXPORTED_PARTS = {
    "msg": (),
    "srv": ("_Event", "_Request", "_Response"),
    "action": (
        "_GetResult_Event", "_GetResult_Request", "_GetResult_Response",
        "_SendGoal_Event", "_SendGoal_Request", "_SendGoal_Response",
    ),
}  # fmt: skip


def lazy_interfaces(module: str) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return `__getattr__` and `__dir__` for a module like 'std_msgs.msg'; makes 'std_msgs.msg._string' importable."""
    package, kind = module.split(".")
    _install_finder()

    def exported() -> list[str]:
        names = [name.partition("/")[2] for name in registry.interface_names(package, kind)]
        has_events = differences.value("services.have_events")
        parts = [part for part in _EXPORTED_PARTS[kind] if has_events or not part.endswith("_Event")]
        return sorted(name + part for name in names for part in ("", *parts))

    def getattr_(name: str) -> Any:
        if name == "__all__":
            return exported()
        # Goals, results and feedback are only in the action's own module, and in its class.
        part = name[name.index("_") :] if kind == "action" and "_" in name else ""
        found = None if part and part not in _EXPORTED_PARTS[kind] else _find(package, kind, name)
        if found is None:
            raise AttributeError(f"module '{module}' has no attribute '{name}'")
        setattr(sys.modules[module], name, found)
        return found

    def dir_() -> list[str]:
        return sorted({*vars(sys.modules[module]), *exported()})

    return getattr_, dir_


def package_files(package: str, kinds: Iterable[str]) -> dict[str, str]:
    """Return the files, by path, that make a package with interfaces of these kinds (msg, srv, action) importable.

    A build installs them for a user's package; the packages that come with day6-tui have the same files.
    """
    files = {f"{package}/__init__.py": _PACKAGE_FILE.format(package=package)}
    for kind in kinds:
        files[f"{package}/{kind}/__init__.py"] = _KIND_FILE.format(word=_WORDS[kind], package=package)
    return files


def _find(package: str, kind: str, name: str) -> Any:
    """Return the class, or None if the module has no such attribute; raises errors in the text itself."""
    if not name[:1].isupper():
        return None
    try:
        return registry.find_class(f"{package}/{kind}/{name}")
    except registry.UnknownInterfaceError as error:
        if registry.base_name(error.interface) == registry.base_name(f"{package}/{kind}/{name}"):
            return None
        raise


class _InterfaceModules:
    """Finds modules like `std_msgs.msg._string`, which have no file; pickle imports them by name."""

    @staticmethod
    def find_spec(fullname: str, path: Sequence[str] | None = None, target: object = None) -> ModuleSpec | None:
        """Return the spec of an interface's own module, None for every other name."""
        package, _, rest = fullname.partition(".")
        kind, _, name = rest.partition(".")
        if kind not in registry.KINDS or not name.startswith("_"):
            return None
        for interface in registry.interface_names(package, kind):
            if module_name(package, kind, interface.partition("/")[2]) == fullname:
                loader: Any = _Loader(package, kind, interface.partition("/")[2])
                return ModuleSpec(fullname, loader)
        return None


class _Loader:
    """Fills the module of one interface: its class, its parts and their metaclasses, each generated on first use."""

    def __init__(self, package: str, kind: str, name: str) -> None:
        self.package = package
        self.kind = kind
        self.name = name

    def create_module(self, spec: ModuleSpec) -> None:
        """Let Python create the module."""

    def exec_module(self, module: ModuleType) -> None:
        """Give the module its lazy attributes."""
        package, kind, base = self.package, self.kind, self.name

        def getattr_(name: str) -> Any:
            plain = name.removeprefix("Metaclass_")
            found = _find(package, kind, plain) if plain.partition("_")[0] == base else None
            if found is None:
                raise AttributeError(f"module '{module.__name__}' has no attribute '{name}'")
            found = type(found) if plain != name else found
            setattr(module, name, found)
            return found

        module.__dict__["__getattr__"] = getattr_


def _install_finder() -> None:
    if _InterfaceModules not in sys.meta_path:
        sys.meta_path.append(_InterfaceModules)
