"""What lies beside the wheels: INSTALL.txt in all languages, the list for pip, and check.py, which any Python 3 can run."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import chain

from packaging.utils import parse_wheel_filename

from day6_core.language import LANGUAGES
from day6_tui.locale import Texts
from day6_tui.wheelhouse.folder import LIST
from day6_tui.wheelhouse.targets import PYTHONS, Target

_INSTALL = f"pip install --no-compile --no-index --find-links . --no-deps -r {LIST}"
"""Without what they require, as the list has all that is used."""


def guide(targets: list[Target]) -> str:
    """Return INSTALL.txt for these kinds of machines."""
    return "\n\n".join(_guide(Texts(language), targets) for language in LANGUAGES)


def _guide(texts: Texts, targets: list[Target]) -> str:
    pythons = [each for each in PYTHONS if any(target.python == each for target in targets)]
    python = pythons[-1]
    check, install, run = [], [], []
    if any(target.platform.os_name == "posix" for target in targets):
        unix = texts("wheelhouse.guide.unix")
        check.append((unix, "python3 check.py"))
        install.append((unix, f"python{python} -m venv ~/day6 && ~/day6/bin/{_INSTALL}"))
        run.append((unix, "~/day6/bin/day6-tui"))
    if any(target.platform.os_name == "nt" for target in targets):
        windows = texts("wheelhouse.guide.windows")
        check.append((windows, "py check.py"))
        install.append((windows, f"py -{python} -m venv $HOME\\day6; & $HOME\\day6\\Scripts\\{_INSTALL}"))
        run.append((windows, "& $HOME\\day6\\Scripts\\day6-tui"))
    return texts(
        "wheelhouse.guide",
        targets="\n".join(f"  {target}" for target in targets),
        check=_steps(check),
        install=_steps(install),
        run=_steps(run),
        other=texts("wheelhouse.guide.other", python=python) if len(pythons) > 1 else "",
    )


def listed(wheels: Mapping[Target, Iterable[str]]) -> str:
    """Return the list for pip: the projects of these wheels, with markers where not all machines have the same."""
    lines = []
    for line in sorted({_pinned(wheel) for wheel in chain(*wheels.values())}):
        where = [target for target, names in wheels.items() if line in map(_pinned, names)]
        marker = "" if len(where) == len(wheels) else f" ; {' or '.join(target.marker for target in where)}"
        lines.append(f"{line}{marker}\n")
    return "".join(lines)


def _pinned(wheel: str) -> str:
    name, version, *_ = parse_wheel_filename(wheel)
    return f"{name}=={version}"


def _steps(steps: list[tuple[str, str]]) -> str:
    return "\n".join(f"   {system}\n     {command}" for system, command in steps)


def checker(targets: list[Target]) -> str:
    """Return check.py for these kinds of machines."""
    known = [(target.platform.name, target.python) for target in targets]
    return _CHECKER.replace("TARGETS = []", f"TARGETS = {known!r}")


_CHECKER = '''\
"""Is this the folder for this machine and this Python, and are all its files whole? python3 check.py"""

import hashlib
import pathlib
import platform
import sys

TARGETS = []
"""The machines and versions of Python that the folder is for."""


def machine():
    """This machine, with the names of TARGETS."""
    system = {"linux": "linux", "darwin": "macos", "win32": "windows"}.get(sys.platform, sys.platform)
    kind = platform.machine().lower()
    kind = {"amd64": "x86_64", "arm64": "arm64" if system == "macos" else "aarch64"}.get(kind, kind)
    return system + "-" + (kind if sys.maxsize > 2**32 else "32-bit")


def python():
    """The version of the Python that runs this; t is one without the GIL, which needs other files."""
    name = "" if sys.implementation.name == "cpython" else sys.implementation.name + " "
    return name + "%d.%d" % sys.version_info[:2] + ("t" if "t" in getattr(sys, "abiflags", "") else "")


def unfit():
    """Say what does not fit, '' if all does."""
    here, version = machine(), python()
    if (here, version) in TARGETS:
        return ""
    versions = [each for name, each in TARGETS if name == here]
    if not versions:
        return "not for this machine (%s): the folder is for %s" % (here, ", ".join(sorted({name for name, _ in TARGETS})))
    command = "py -%s" if sys.platform == "win32" else "python%s"
    ways = " or ".join((command + " check.py") % each for each in versions)
    return "this is Python %s, the folder is for Python %s: %s" % (version, " and ".join(versions), ways)


def damaged():
    """The files that differ from SHA256SUMS, or are missing."""
    here = pathlib.Path(__file__).resolve().parent
    for line in (here / "SHA256SUMS").read_text(encoding="utf-8").splitlines():
        digest, _, name = line.partition("  ")
        path = here / name
        if not path.is_file() or hashlib.sha256(path.read_bytes()).hexdigest() != digest:
            yield name


wrong = list(damaged())
for each in wrong:
    print("missing or damaged:", each)
print("copy the folder again, or fill it again with day6-tui wheelhouse" if wrong else "all files are whole")
if unfit():
    print(unfit())
else:
    print("the folder is for this machine (%s) and this Python (%s)" % (machine(), python()))
sys.exit(bool(wrong or unfit()))
'''
