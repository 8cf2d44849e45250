"""Computes the environment changes of sourcing a workspace from the .dsv files that packages install.

The build copies this file into `install/`, where the setup scripts of real shells run it with any Python 3; the simulated
terminal imports it. So it imports nothing of ours. The kinds of line in a .dsv file, with parts separated by `;` (as colcon
writes and reads them): `prepend-non-duplicate;NAME;VALUE…`, `prepend-non-duplicate-if-exists`, `append-non-duplicate`, `set`,
`set-if-unset`, `source;PATH`. A relative value is below the package's prefix.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping


class Environment:
    """Variables being changed. `changed` has the new values, `scripts` the hooks only a shell can run."""

    def __init__(self, variables: Mapping[str, str]) -> None:
        self.variables = dict(variables)
        self.changed: dict[str, str] = {}
        self.scripts: list[tuple[str, str]] = []

    def set(self, name: str, value: str) -> None:
        """Set a variable."""
        self.variables[name] = self.changed[name] = value

    def extend(self, name: str, value: str, front: bool = True) -> None:
        """Add `value` to a list of paths unless it is in it already."""
        entries = [entry for entry in self.variables.get(name, "").split(os.pathsep) if entry]
        if value not in entries:
            self.set(name, os.pathsep.join([value, *entries] if front else [*entries, value]))

    def put_first(self, name: str, value: str) -> None:
        """Make `value` the first of a list of paths."""
        entries = [entry for entry in self.variables.get(name, "").split(os.pathsep) if entry]
        self.set(name, os.pathsep.join([value, *(entry for entry in entries if entry != value)]))


def source_workspace(install: str, environment: Environment) -> None:
    """Do what `local_setup` does: source every package of the install folder, dependencies first."""
    environment.put_first("COLCON_PREFIX_PATH", install)
    merged = _layout(install) == "merged"
    for name in _in_order(_needs(install, merged)):
        source_package(install if merged else os.path.join(install, name), name, environment)


def source_package(prefix: str, name: str, environment: Environment) -> None:
    """Do what `share/NAME/package` does for one package."""
    source_dsv(os.path.join(prefix, "share", name, "package.dsv"), prefix, environment)


def source_dsv(path: str, prefix: str, environment: Environment) -> None:
    """Apply the lines of a .dsv file; a missing file changes nothing.

    Raises:
        ValueError: a line is of an unknown kind.
    """
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except OSError:
        return
    hooks: dict[str, set[str]] = {}
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.startswith("#"):
            continue
        kind, _, rest = line.partition(";")
        if kind == "source":
            base, extension = os.path.splitext(rest)
            hooks.setdefault(base, set()).add(extension)
        elif not _apply(kind, rest.split(";"), prefix, environment):
            raise ValueError(f"Line {number} in '{path}' contains an unknown environment hook type: {kind}")
    for base, extensions in hooks.items():
        whole = base if os.path.isabs(base) else os.path.join(prefix, base)
        if os.path.exists(whole + ".dsv"):
            source_dsv(whole + ".dsv", prefix, environment)
        else:
            environment.scripts.extend((prefix, whole + extension) for extension in sorted(extensions))


def _apply(kind: str, parts: list[str], prefix: str, environment: Environment) -> bool:
    name, values = parts[0], parts[1:]
    if kind in ("set", "set-if-unset"):
        value = values[0] if values else ""
        below = os.path.join(prefix, value) if value else prefix
        if kind == "set" or not environment.variables.get(name):
            environment.set(name, below if os.path.exists(below) else value)
        return True
    if kind not in ("prepend-non-duplicate", "prepend-non-duplicate-if-exists", "append-non-duplicate"):
        return False
    for value in values:
        path = value if os.path.isabs(value) else os.path.join(prefix, value) if value else prefix
        if kind != "prepend-non-duplicate-if-exists" or os.path.exists(path):
            environment.extend(name, path, front=kind != "append-non-duplicate")
    return True


def _layout(install: str) -> str:
    try:
        with open(os.path.join(install, ".colcon_install_layout"), encoding="utf-8") as file:
            return file.read().strip()
    except OSError:
        return "isolated"


def _needs(install: str, merged: bool) -> dict[str, set[str]]:
    """Return {package: names of its run-time dependencies} from the files in share/colcon-core/packages."""
    found: dict[str, set[str]] = {}
    for entry in sorted(os.listdir(install)) if not merged else [""]:
        folder = os.path.join(install, entry, "share", "colcon-core", "packages")
        if entry.startswith(".") or not os.path.isdir(folder):
            continue
        for name in sorted(os.listdir(folder)):
            if merged or name == entry:
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    found[name] = set(file.read().split(os.pathsep))
    return {name: needs & set(found) - {name} for name, needs in found.items()}


def _in_order(needs: dict[str, set[str]]) -> list[str]:
    ordered = []
    left = {name: set(names) for name, names in needs.items()}
    while left:
        ready = sorted(name for name, names in left.items() if not names)
        if not ready:
            raise ValueError("Circular dependency between: " + ", ".join(sorted(left)))
        name = ready[0]
        ordered.append(name)
        del left[name]
        for names in left.values():
            names.discard(name)
    return ordered


def _quoted(text: str) -> str:
    return "'" + text.replace("'", "'\"'\"'") + "'"


def _lines(environment: Environment, shell: str) -> Iterator[str]:
    """Yield the commands for the changes in a shell: 'sh' (also bash and zsh), 'ps1' or 'bat'."""
    for name, value in environment.changed.items():
        if shell == "ps1":
            doubled = value.replace("'", "''")
            yield f"$env:{name}='{doubled}'"
        elif shell == "bat":
            yield f'set "{name}={value}"'
        else:
            yield f"export {name}={_quoted(value)}"
    for prefix, script in environment.scripts:
        if shell == "sh" and script.endswith(".sh"):
            yield f"COLCON_CURRENT_PREFIX={_quoted(prefix)}; . {_quoted(script)}; unset COLCON_CURRENT_PREFIX"
        elif shell == "ps1" and script.endswith(".ps1"):
            yield f"$env:COLCON_CURRENT_PREFIX='{prefix}'; . '{script}'"


def main(arguments: list[str]) -> int:
    """Run `_local_setup_util_sh.py sh|ps1|bat [PACKAGE PREFIX]`: print the commands for the workspace, or for one package."""
    environment = Environment(os.environ)
    try:
        if len(arguments) == 3:
            source_package(arguments[2], arguments[1], environment)
        else:
            source_workspace(os.path.dirname(os.path.abspath(__file__)), environment)
    except OSError as error:
        print(f"{error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    except ValueError as error:
        print(error, file=sys.stderr)
        return 1
    for line in _lines(environment, arguments[0]):
        print(line)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
