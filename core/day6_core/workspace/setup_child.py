"""Runs a student's setup.py for the build, as a separate process with setuptools installed, in the package's folder.

First it reports the arguments of setup(): one line of JSON after a mark on standard output, the mark alone on standard error.
Then it reads one line of JSON, {"cwd": …, "commands": […]}, and runs those setuptools commands there. Exceptions of setup.py
are not caught, so a traceback names the student's line.
"""

from __future__ import annotations

import configparser
import functools
import importlib
import importlib.metadata
import json
import os
import sys
import warnings
from typing import Any

MARK = "\x1e"
TAKES_TESTS_REQUIRE = "--takes-tests-require"
"""Given where the distribution's setuptools still has that argument of setup()."""

_FIELDS = ("data_files", "packages", "package_dir", "package_data", "py_modules", "scripts")


def main() -> None:
    """Report the arguments of setup(), then run the requested commands."""
    sys.path[0] = os.getcwd()
    _ignore_newer_warnings()
    _read_entry_points_once()
    importlib.import_module("setuptools")
    core = importlib.import_module("distutils.core")
    distribution = core.run_setup("setup.py", [], "config")
    described = {name: _plain(getattr(distribution, name, None)) for name in _FIELDS}
    described["name"] = distribution.get_name()
    described["options"] = {section: _options(distribution, section) for section in ("develop", "install")}
    sys.stderr.flush()
    sys.stderr.write(MARK + "\n")
    sys.stderr.flush()
    sys.stdout.write(MARK + json.dumps(described) + "\n")
    sys.stdout.flush()
    line = sys.stdin.readline()
    if not line:
        return
    request = json.loads(line)
    os.chdir(request["cwd"])
    sys.path[0] = os.getcwd()
    _ignore_newer_warnings()  # a changed filter also makes Python repeat its warnings, as a second process would
    core.run_commands(core.run_setup("setup.py", request["commands"], "commandline"))


def _ignore_newer_warnings() -> None:
    """Suppress warnings of things that the setuptools of this distribution's Ubuntu still accepts."""
    warnings.filterwarnings("ignore", message=r"(?s).*setup\.py install is deprecated")
    if TAKES_TESTS_REQUIRE in sys.argv:
        warnings.filterwarnings("ignore", message=r"Unknown distribution option: 'tests_require'")
    warnings.filterwarnings("ignore", message=r"(?s).*License classifiers are deprecated")
    # The build sets all folders; the system's own distutils would change them.
    os.environ.setdefault("SETUPTOOLS_USE_DISTUTILS", "local")


def _read_entry_points_once() -> None:
    """Read once what each installed distribution offers: setuptools asks nineteen times, a quarter of a small build."""
    read = importlib.metadata.entry_points

    @functools.cache
    def all_of(path: tuple[str, ...]) -> Any:
        return read()

    def entry_points(**wanted: Any) -> Any:
        found = all_of(tuple(sys.path))
        return found.select(**wanted) if wanted else found

    importlib.metadata.entry_points = entry_points


def _options(distribution: Any, section: str) -> dict[str, str]:
    """Return the options of a command, names with `_`.

    In a virtual environment setuptools drops options like `install-scripts` if setup.cfg writes them with a dash; a ROS
    installation's interpreter is not in one, and files from Foxy use dashes.
    """
    parser = configparser.ConfigParser(interpolation=None)
    parser.read("setup.cfg", encoding="utf-8")
    found = dict(parser.items(section)) if parser.has_section(section) else {}
    found.update({name: str(value[1]) for name, value in distribution.get_option_dict(section).items()})
    return {name.replace("-", "_"): value for name, value in found.items()}


def _plain(value: Any) -> Any:
    """Make a value JSON: tuples and iterators become lists, anything else its text."""
    if isinstance(value, dict):
        return {str(key): _plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple, set, map, filter)) or hasattr(value, "__next__"):
        return [_plain(each) for each in value]
    return value if value is None or isinstance(value, (str, int, float, bool)) else str(value)


if __name__ == "__main__":
    main()
