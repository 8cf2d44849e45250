"""Makes a bare checkout importable and gives every test its whole environment.

Of the caller's variables only those of KEPT reach a test: they say where this machine keeps its programs. Locale, terminal,
time zone, home folder, umask and current folder are the same on every machine; a test that wants others sets them itself.
"""

from __future__ import annotations

import gc
import importlib.util
import itertools
import os
import platform
import shutil
import signal
import string
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from tests.support import (
    choosing,
    one_process,
    short_sockets,
    skips,
    virtual_time,
    waiting,  # noqa: F401 - before sleeping is watched
)
from tests.support.other_distribution import in_distribution, nothing_chosen  # noqa: F401
from tests.support.rights import plain_user  # noqa: F401
from tests.support.short_folder import make_short_folder, remove_short_folders

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parent

if importlib.util.find_spec("day6_core") is None:
    sys.path += [str(ROOT / name) for name in ("core", "tui", "urdf")]

# What yourdfpy brings, and an installation by requirements/everything.txt has not: nothing may lean on it.
UNUSED = "colorlog embreex manifold3d mapbox_earcut networkx rtree scipy shapely svg vhacdx"
for name in UNUSED.split():
    sys.modules.setdefault(name, None)  # type: ignore[arg-type]

# How long an example takes says something about the machine.
settings.register_profile("patient", deadline=None, suppress_health_check=[HealthCheck.too_slow])
# Odd surroundings are the same for every example; all of them are played in plain ones.
settings.register_profile("odd", settings.get_profile("patient"), max_examples=20)
settings.load_profile("odd" if "DAY6_TESTS_ODD" in os.environ else "patient")

KEPT = frozenset(
    [
        *("PATH", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH"),
        *("SYSTEMROOT", "SYSTEMDRIVE", "COMSPEC", "PATHEXT", "WINDIR", "TEMP", "TMP", "PROGRAMDATA"),
        *(
            *("DAY6_AXE", "DAY6_AXE_TO"),
            "DAY6_PYRIGHT",
            "DAY6_REAL_COLCON",
            "DAY6_REAL_PYTHON",
            "DAY6_ROBOTS",
            "DAY6_TESTS_ODD",
            "DAY6_UPDATE_GOLDEN",
        ),
    ]
)
"""Where the system's programs are, and which optional ones a developer names for a test."""

ODD = bool(os.environ.get("DAY6_TESTS_ODD"))
"""Whether every test gets other values where none may depend on them (.ci/hostile)."""

SPREAD = (
    "tests/advice/test_mistakes.py",
    "tests/conformance/test_programs.py",
    "tests/docs/test_blocks.py",
    *(f"tests/e2e/test_{first}" for first in string.ascii_lowercase if first != "s"),  # those of test_signals share one
    *(f"tests/inspector/test_{name}.py" for name in ("drills", "healthy", "lessons_end", "tutorials")),
    *(f"tests/shell/test_{name}.py" for name in ("endless", "execute", "process")),
    *(f"tests/workspace/test_{name}.py" for name in ("interface_packages", "sources_stay", "tests")),
)
"""Files of long tests that share nothing, not even a fixture of their module."""

FIRST = tuple(
    f"tests/{name}.py"
    for name in ("inspector/test_lessons_end", "lessons/test_played", "grading/test_forgeries", "grading/test_office")
)
"""Files of tests that wait for half a minute and more: the others are done meanwhile."""

MUCH_GARBAGE, MANY_COLLECTIONS = 50_000, 20
"""Objects that are new since the last collection; collections of young objects since the last one of all."""

# Short, because it holds sockets; and it may be anywhere, because no test should depend on where temporary files are.
OWN = make_short_folder("d6t-")
# Where it is told that a program makes all the others wait (day6_core/session/watch.py), if it was started for several tests.
WAITS = OWN / "waits.txt"
_numbers = itertools.count()


def environment() -> dict[str, str]:
    """Return the variables that every test starts with; the folders among them are made."""
    folders = {name: OWN / name for name in ("link", "log", "data", "config", "cache", "state")}
    folders["home"] = OWN / ("the home 家 of nobody" if ODD else "home")
    for folder in folders.values():
        folder.mkdir(mode=0o700, exist_ok=True)
    kept = {name: value for name, value in os.environ.items() if name.upper() in KEPT or name.startswith("PYTEST_")}
    return {
        **kept,
        "TMPDIR": tempfile.gettempdir(),
        "HOME": str(folders["home"]),
        "LOGNAME": "student",
        "USERPROFILE": str(folders["home"]),
        "XDG_DATA_HOME": str(folders["data"]),
        "XDG_CONFIG_HOME": str(folders["config"]),
        "XDG_CACHE_HOME": str(folders["cache"]),
        "XDG_STATE_HOME": str(folders["state"]),
        "LANG": "de_DE.UTF-8" if ODD else "C.UTF-8",
        "TERM": "xterm-256color",
        "TZ": "Pacific/Kiritimati" if ODD else "UTC",
        # Nothing a test starts may meet the desktop this developer has open, or log below ~/.ros.
        "DAY6_RUNTIME_DIR": str(folders["link"]),
        "DAY6_LINK": "off",
        "DAY6_WATCH": str(WAITS),
        "ROS_LOG_DIR": str(folders["log"]),
        **virtual_time.variables(os.environ),
    }


def set_environment(variables: dict[str, str]) -> None:
    """Make these the process's variables, whatever it had."""
    os.environ.clear()
    os.environ.update(variables)
    if hasattr(time, "tzset"):
        time.tzset()


# Already here: modules read variables while they are imported, and the processes of pytest-xdist inherit them.
set_environment(environment())
os.umask(0o022)
# A shell without job control starts what is put behind an `&` deaf to these, and so does nohup; programs would inherit it.
for number in {
    signal.SIGINT,
    signal.SIGTERM,
    *(getattr(signal, f"SIG{name}", signal.SIGINT) for name in ("HUP", "QUIT")),
}:
    if signal.getsignal(number) is signal.SIG_IGN:
        signal.signal(number, signal.default_int_handler if number == signal.SIGINT else signal.SIG_DFL)

from day6_core.interfaces import registry  # noqa: E402
from day6_core.ros.environment import activate  # noqa: E402

activate()

platform.processor()  # asks another program, once in a process: a test that comes first must not have to
one_process.install()
short_sockets.install()

_MONOTONIC = time.monotonic


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--whole", action="store_true", help="all tests, not only those of the default layer")
    parser.addoption("--switch-interval", type=float, metavar="SECONDS", help="how soon Python lets another thread run")
    skips.add_option(parser)


def pytest_configure(config: pytest.Config) -> None:
    """Choose the default layer, unless `-m` or `--whole` chooses, or all that is named are files."""
    if (interval := config.getoption("--switch-interval")) is not None:
        sys.setswitchinterval(interval)
    for name, what in {**one_process.LAYERS, virtual_time.MARK: "runs in a pytest of its own, in virtual time"}.items():
        config.addinivalue_line("markers", f"{name}: {what}")
    chosen = config.getoption("--whole") or any(word.startswith("-m") for word in config.invocation_params.args)
    if not chosen and not all(".py" in word for word in config.args):
        config.option.markexpr = f"not ({' or '.join(one_process.LAYERS)})"


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Import no file, of a whole folder, in which `-m` chooses nothing."""
    named = any(".py" in word for word in config.args)
    return True if not named and choosing.left_out(collection_path, config.option.markexpr) else None


def pytest_collection_finish() -> None:
    """Collect garbage only between tests: finalizers of an earlier one have no place in deep recursions of the next.

    What stays until the end is spared: it took a fourteenth of the time of a run.
    """
    gc.collect()
    gc.freeze()
    gc.disable()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Set up nothing here for a test that runs in virtual time, in a pytest of its own."""
    virtual_time.leave_out_fixtures(item)


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Run such a test there."""
    return virtual_time.run(pyfuncitem)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Confine the tests of the default layer to this process."""
    one_process.begin(item)
    try:
        return (yield)
    finally:
        one_process.end()
        if gc.get_count()[0] > MUCH_GARBAGE:
            gc.collect(2 if gc.get_count()[2] > MANY_COLLECTIONS else 1)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_teardown() -> Iterator[None]:
    """Leave no test a clock that stands still: it would wait for ever."""
    yield
    left, time.monotonic = time.monotonic, _MONOTONIC
    assert left is _MONOTONIC, "time.monotonic is still patched"


def _unit(nodeid: str) -> str:
    """The piece of work that a test belongs to: its file, or the test alone."""
    file = nodeid.partition("::")[0]
    return nodeid if file.startswith(SPREAD) else file


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> Iterator[None]:
    """With pytest-xdist, order by what takes longest, so that nobody is left with it in the end."""
    choosing.judge(items)
    yield
    if "PYTEST_XDIST_WORKER" in os.environ:
        sizes = Counter(_unit(item.nodeid) for item in items)
        items.sort(key=lambda item: (not item.nodeid.startswith(FIRST), -sizes[_unit(item.nodeid)]))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Give each process of pytest-xdist one unit after the other, in the order of `pytest_collection_modifyitems`."""
    from xdist.scheduler import LoadScopeScheduling

    class ByUnit(LoadScopeScheduling):
        _split_scope = staticmethod(_unit)

    config.option.loadscopereorder = False
    return ByUnit(config, log)


@pytest.fixture(autouse=True)
def _own_text_tools(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tests of the default layer start no processes: the text tools are ours, as on a machine without GNU's."""
    if one_process.confined(request.node):
        monkeypatch.setattr("day6_core.shell.text_tools.MACHINES", False)


@pytest.fixture(autouse=True)
def own_environment() -> Iterator[None]:
    """Start in an empty folder.

    What a test does to variables, current folder, umask, sourced packages and Python's path ends with it.
    """
    before, folder, sourced, path = dict(os.environ), os.getcwd(), list(registry._more_prefixes), list(sys.path)
    os.chdir(os.environ["HOME"])
    yield
    if registry._more_prefixes != sourced:
        registry._more_prefixes[:] = sourced
        registry.forget("")
    sys.path[:] = path  # another distribution's folder would be in the place of this one's
    os.umask(0o022)
    os.chdir(folder)
    if dict(os.environ) != before:
        set_environment(before)


@pytest.fixture(autouse=True)
def needs_nothing_but_this_process(own_environment: None) -> Iterator[None]:
    """Fail a test of the default layer that did what only others may, also where the error was swallowed."""
    yield
    one_process.end()  # what fixtures of several tests do at their end isn't this one's doing
    if said := one_process.violations():
        pytest.fail("\n".join(said), pytrace=False)


@pytest.fixture(autouse=True)
def nothing_waits_on_the_schedulers_thread(own_environment: None) -> Iterator[None]:
    """Fail where a call that may block was made on the thread that runs all programs, here or in a desktop of the test.

    The test has a file of its own, so that what an earlier one left running cannot fail it.
    """
    own = OWN / f"waits-{next(_numbers)}.txt"
    os.environ["DAY6_WATCH"] = str(own)
    WAITS.unlink(missing_ok=True)
    yield
    if said := "".join(file.read_text(encoding="utf-8") for file in (own, WAITS) if file.exists()):
        pytest.fail(said, pytrace=False)


def pytest_sessionfinish(session: pytest.Session) -> None:
    skips.judge(session)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    skips.tell(terminalreporter)


@pytest.fixture
def short_folder() -> Iterator[Path]:
    """A folder whose name leaves room for a socket's (pytest's own are too long)."""
    folder = make_short_folder()
    yield folder
    shutil.rmtree(folder, ignore_errors=True)


def pytest_unconfigure() -> None:
    """Take the folders of this run away."""
    remove_short_folders()
