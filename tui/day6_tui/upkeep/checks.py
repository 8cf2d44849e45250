"""What `day6-tui doctor` looks at: one function for each part of the report, which tries things rather than believing them.

Every check may take a while or stand still: the doctor runs each in a thread of its own, with a limit of time.
"""

from __future__ import annotations

import difflib
import importlib.util
import os
import platform
import re
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from day6_core.graph.domain import DomainError, domain_from_text
from day6_core.guardian import MARK
from day6_core.language import LANGUAGES, language_of
from day6_core.link import engine
from day6_core.link.paths import LinkError, base_folders, count_with_zenoh, meeting_place
from day6_core.parts import PROJECTS, has_part
from day6_core.places import PLACES, data_folder, default_home, runtime_folders
from day6_core.reason import reason
from day6_core.ros import distribution
from day6_core.ros.environment import is_foreign_ros
from day6_core.ros.executables import is_executable_of_ours
from day6_core.system.memory import available, total_memory
from day6_core.variables import VARIABLES, shown_value
from day6_tui.appearance.glyphs import detect, is_colourless, speaks_utf8, terminal_environ
from day6_tui.upkeep import trials
from day6_tui.upkeep.installation import installation
from day6_tui.upkeep.line import Line, note, ok, problem
from day6_tui.upkeep.removal import size_of
from day6_tui.upkeep.running import running
from day6_tui.wheelhouse.targets import PYTHONS, this_python

SMALLEST_SCREEN = (80, 24)
LITTLE_SPACE, VERY_LITTLE_SPACE = 1_000_000_000, 100_000_000
LITTLE_MEMORY = 500_000_000
FEW_FILES = 256
NOTEWORTHY = ("DAY6_", "ROS_", "RCUTILS_", "RMW_", "AMENT_", "COLCON_")


def version() -> Iterator[Line]:
    found = installation()
    if not found.kind:
        yield note("version.checkout", folder=found.source)
        return
    yield ok("version.installed", version=found.version, kind=found.kind)
    if found.source is not None:
        yield ok("version.editable", folder=found.source)


def python() -> Iterator[Line]:
    values = {"version": platform.python_version(), "kind": platform.python_implementation(), "path": sys.executable}
    in_venv = sys.prefix != sys.base_prefix
    if this_python() in PYTHONS:
        yield ok("python.venv" if in_venv else "python.bare", **values)
    else:
        yield note("python.untested", "python.untested.todo", **values)
    if os.environ.get("PYTHONHOME"):
        yield problem("python.home", "python.home.todo")


def system() -> Iterator[Line]:
    yield ok("system", name=_system_name(), machine=platform.machine(), processors=os.cpu_count() or "?")
    for kind, is_there in _SURROUNDINGS.items():
        if is_there():
            yield note(f"system.{kind}")


def _system_name() -> str:
    if sys.platform == "linux":
        try:
            name = platform.freedesktop_os_release().get("PRETTY_NAME", "Linux")
        except OSError:
            name = "Linux"
        return f"{name}, Linux {platform.release()}"
    if sys.platform == "darwin":
        return f"macOS {platform.mac_ver()[0]}"
    return f"{platform.system()} {platform.release()} ({platform.version()})"


def _contents(path: str) -> str:
    try:
        return Path(path).read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""


_SURROUNDINGS: dict[str, Callable[[], bool]] = {
    "container": lambda: (
        any(map(os.path.exists, ("/.dockerenv", "/run/.containerenv"))) or "container=" in _contents("/proc/1/environ")
    ),
    "wsl": lambda: "microsoft" in platform.release().lower(),
    "virtual": lambda: re.search(r"^flags\s*:.*\bhypervisor\b", _contents("/proc/cpuinfo"), re.MULTILINE) is not None,
    "ssh": lambda: "SSH_CONNECTION" in os.environ,
    "tmux": lambda: "TMUX" in os.environ,
    "screen": lambda: "STY" in os.environ,
    "desktop": lambda: MARK in os.environ,
}
"""What is around this program, and how it is recognised."""


def terminal() -> Iterator[Line]:
    environ = terminal_environ()
    term, colour = environ.get("TERM", ""), environ.get("COLORTERM", "")
    if not sys.stderr.isatty() or not sys.stdin.isatty():
        yield note("terminal.none", term=term or "-")
    else:
        size = os.get_terminal_size(sys.stderr.fileno())
        enough = size.columns >= SMALLEST_SCREEN[0] and size.lines >= SMALLEST_SCREEN[1]
        values = {"term": term or "-", "colour": colour or "-", "columns": size.columns, "lines": size.lines}
        if term in ("", "dumb") and sys.platform != "win32":
            yield problem("terminal.dumb", "terminal.dumb.todo", **values)
        else:
            yield ok("terminal", **values) if enough else note("terminal.small", "terminal.small.todo", **values)
    yield _colours(environ)
    yield from _glyphs(environ)


def _colours(environ: Mapping[str, str]) -> Line:
    from day6_tui.screen.adaptation import colour_system

    if environ.get("NO_COLOR"):
        return note("terminal.no_colour")
    if is_colourless(environ):
        return note("terminal.no_colour.dumb", term=environ.get("TERM", ""))
    return ok("terminal.colours", kind=colour_system(environ).name.lower().replace("_", " "))


def _glyphs(environ: Mapping[str, str]) -> Iterator[Line]:
    from day6_tui.pixels.ask import may_be_asked

    name, encoding = detect(environ), sys.stdout.encoding
    if not speaks_utf8(environ):
        yield note("glyphs.no_utf8", "glyphs.no_utf8.todo", encoding=encoding)
    elif name != "half":
        yield note("glyphs.simple", name=name, term=environ.get("TERM", ""))
    else:
        yield ok("glyphs.half", encoding=encoding)
    asked = name == "half" and may_be_asked(environ)
    yield ok("glyphs.pixels.asked") if asked else note("glyphs.pixels.never")


def language() -> Iterator[Line]:
    named = {
        name: os.environ[name]
        for name in ("LC_ALL", "LC_CTYPE", "LC_MESSAGES", "LANGUAGE", "LANG")
        if name in os.environ
    }
    found = " ".join(f"{name}={value}" for name, value in named.items()) or "-"
    given = os.environ.get("DAY6_LANG", "")
    if given and given not in LANGUAGES:
        yield problem("language.unknown", "language.unknown.todo", given=given, languages=", ".join(LANGUAGES))
    by = (
        "DAY6_LANG"
        if given in LANGUAGES
        else next((n for n in ("LC_ALL", "LC_MESSAGES", "LANGUAGE", "LANG") if named.get(n)), "")
    )
    yield ok("language.by" if by else "language.default", language=language_of(os.environ), by=by, locale=found)


def ros() -> Iterator[Line]:
    yield _distribution(terminal_environ())
    real = [path for path in sorted(Path("/opt/ros").glob("*")) if (path / "setup.bash").exists()]
    entries = [each for each in os.environ.get("PYTHONPATH", "").split(os.pathsep) if each]
    foreign = [each for each in entries if is_foreign_ros(each)]
    ros2 = shutil.which("ros2")
    if foreign or (ros2 is not None and not is_executable_of_ours(Path(ros2))):
        yield note("ros.sourced", what=foreign[0] if foreign else ros2)
    elif real:
        yield note("ros.installed", what=", ".join(map(str, real)))
    else:
        yield ok("ros.none")


def _distribution(environ: Mapping[str, str]) -> Line:
    """The distribution, and by what it was chosen."""
    from day6_tui.distribution_choice import SETTING
    from day6_tui.settings import Settings

    name, named = distribution.current(), environ.get("ROS_DISTRO", "")
    on_path = distribution.on_path(environ.get("PYTHONPATH", "").split(os.pathsep))
    by = {
        "handed_on": environ.get(distribution.HANDED_ON, ""),
        "sourced": on_path or "",
        "variable": named,
        "remembered": Settings().text(SETTING),
    }
    reason = next((key for key, value in by.items() if value == name), "")
    if named and named not in distribution.NAMES:
        return note("ros.other", "ros.other.todo", name=name, given=named, names=", ".join(distribution.NAMES))
    return ok(f"ros.by.{reason or ('default' if name == distribution.DEFAULT else 'option')}", name=name)


def packages() -> Iterator[Line]:
    """Installed versions against what was declared, then every one imported by a Python of its own."""
    from day6_tui import textual_private

    found = trials.requirements()
    if not found:
        yield note("packages.unknown")
    for each in found:
        if each.version is None and each.extra:
            yield note(f"packages.extra.{each.extra}", name=each.name)
        elif each.version is None and each.name in PROJECTS.values():
            yield note(f"packages.part.{each.name}", "packages.part.todo", name=each.name)
        elif each.version is None:
            yield problem("packages.missing", "packages.todo", name=each.name, wanted=each.wanted)
        elif not each.fits:
            yield problem("packages.wrong", "packages.todo", name=each.name, version=each.version, wanted=each.wanted)
    there = [each for each in found if each.version is not None]
    if there:
        yield ok("packages.versions", versions=", ".join(f"{each.name} {each.version}" for each in there))
    if textual_private.supported():
        yield ok("packages.textual", version=textual_private.version(), tested=textual_private.TESTED)
    else:
        yield problem(
            "packages.textual.untested",
            "packages.textual.todo",
            version=textual_private.version(),
            tested=textual_private.TESTED,
        )
    modules = tuple(each for each in trials.MODULES if each not in PROJECTS or has_part(each))
    failed = trials.failing_imports(modules)
    if reason := failed.pop("zenoh", ""):
        yield note("packages.zenoh", "packages.zenoh.todo", reason=reason)
    yield from (
        problem("packages.import", "packages.todo", name=name, reason=reason) for name, reason in failed.items()
    )
    if not failed:
        yield ok("packages.imports", count=len(modules) - bool(reason))


def extras() -> Iterator[Line]:
    missing = [name for name in ("aiohttp", "segno") if importlib.util.find_spec(name) is None]
    yield note("extras.serve.missing", "extras.serve.todo") if missing else ok("extras.serve")


def folders() -> Iterator[Line]:
    from day6_tui.settings import Settings

    yield _folder("data", data_folder())
    yield _folder("home", default_home())
    yield _folder("temporary", Path(tempfile.gettempdir()))
    yield _folder("runtime", runtime_folders()[0])
    for place in PLACES:
        if place.base == "data" and place.name != "home":
            for path in place.found():
                yield ok("folders.has", path=path, size=size_of(path, 2.0))
    settings = Settings()
    if settings.fault:
        yield problem("folders.settings", "folders.settings.todo", path=settings.path, reason=settings.fault)


OURS = ("data", "home")
"""Folders of which nearly all is ours, so that their size says something."""


def _folder(name: str, folder: Path) -> Line:
    """Whether files can be written there, or where the folder would be created."""
    there = next(each for each in (folder, *folder.parents) if each.exists())
    reason = trials.cannot_write(there)
    if reason:
        return problem("folders.no_write", "folders.no_write.todo", path=there, reason=reason)
    free = shutil.disk_usage(there).free
    values: dict[str, object] = {"path": folder, "free": f"{free / 1e9:.1f} GB"}
    if name in OURS and folder.exists():
        values["size"] = size_of(folder, 2.0)
    if free < VERY_LITTLE_SPACE:
        return problem("folders.full", "folders.full.todo", **values)
    if free < LITTLE_SPACE:
        return note("folders.little", "folders.full.todo", **values)
    return ok(f"folders.{name}" if folder.exists() else "folders.not_yet", **values)


def sockets() -> Iterator[Line]:
    """A socket like those by which programs meet, opened and reached."""
    try:
        folder = base_folders()[0]
        place = meeting_place(_domain())
    except LinkError as error:
        yield problem("sockets.nowhere", "sockets.nowhere.todo", reason=error)
        return
    except DomainError:
        return  # `graph` reports it
    yield from (note("sockets.passed_over", reason=reason) for reason in place.passed_over)
    if engine.is_chosen():
        yield note("sockets.chosen", value=os.environ["DAY6_LINK"])
    if count := count_with_zenoh(place):
        yield note("sockets.with_zenoh", "sockets.with_zenoh.todo", count=count)
    try:
        trials.meet(None if place.tcp else folder)
    except OSError as error:
        yield problem("sockets.fail", "sockets.nowhere.todo", path=folder, reason=reason(error))
    else:
        yield ok("sockets.tcp" if place.tcp else "sockets", path=folder)


def _domain() -> int:
    """The domain of this terminal. Raises DomainError."""
    return domain_from_text(os.environ.get("ROS_DOMAIN_ID", ""))


def programs() -> Iterator[Line]:
    """Two real programs: one publishes with rclpy, the other one waits for the message."""
    if os.environ.get("DAY6_LINK") == "off":
        yield note("programs.off")
    reason = trials.one_message()
    yield problem("programs.fail", "programs.todo", reason=reason) if reason else ok("programs")


def graph() -> Iterator[Line]:
    """Who is on this domain, and whether anything runs that is not seen from it."""
    try:
        domain = _domain()
    except DomainError as error:
        yield problem("graph.domain", "graph.domain.todo", reason=error)
        return
    found = running()
    here = [each for each in found if each.kind == "program" and each.domain == str(domain)]
    others = sorted({each.domain for each in found if each.kind == "program"} - {str(domain)})
    yield ok("graph.programs", domain=domain, count=len(here)) if here else ok("graph.nobody", domain=domain)
    if others:
        yield note("graph.others", domains=", ".join(others))
    for kind in ("desktop", "server"):
        if count := sum(each.kind == kind for each in found):
            yield note(f"graph.{kind}", count=count)


def limits() -> Iterator[Line]:
    if sys.platform != "win32":
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        values = {"soft": _number(soft), "hard": _number(hard)}
        few = soft != resource.RLIM_INFINITY and soft < FEW_FILES
        yield problem("limits.files.few", "limits.files.todo", **values) if few else ok("limits.files", **values)
    if total := total_memory():
        found = available()
        values = {"total": f"{total / 1e9:.1f} GB", "free": f"{found.free / 1e9:.1f} GB" if found else "?"}
        little = found is not None and found.free < LITTLE_MEMORY
        yield note("limits.memory.little", "limits.memory.todo", **values) if little else ok("limits.memory", **values)
    from day6_core.shell.process.memory import is_held_by_system, memory_limit

    most = memory_limit()
    key = "limits.program" if is_held_by_system() else "limits.program.watched"
    yield ok(key, most=f"{most / 1e9:.1f} GB") if most else ok("limits.program.none")


def _number(limit: int) -> str:
    return "∞" if limit < 0 or limit >= 1 << 62 else str(limit)


def isolation() -> Iterator[Line]:
    """The ways to keep pupils of `serve` apart, each one tried."""
    from day6_core.isolation import modes

    for offer in modes.survey():
        separates = offer.mode is not None and offer.mode.separates
        if separates:
            yield ok("isolation.separates", name=offer.name)
        elif offer.reason is not None:
            yield note("isolation.no", name=offer.name, reason=offer.reason)
        else:
            yield ok("isolation.none", name=offer.name)


def variables() -> Iterator[Line]:
    known = {each.name: each for each in VARIABLES}
    wanted = sorted(name for name in os.environ if name.startswith(NOTEWORTHY))
    for name in wanted:
        yield ok("variables", name=name, value=shown_value(name, os.environ[name]))
        if name.startswith("DAY6_") and name not in known:
            close = difflib.get_close_matches(name, known, 1)
            yield note("variables.close" if close else "variables.unknown", name=name, close=close[0] if close else "")
    if not wanted:
        yield ok("variables.none")


CHECKS: tuple[tuple[Callable[[], Iterator[Line]], float], ...] = (
    (version, 5),
    (python, 5),
    (system, 5),
    (terminal, 5),
    (language, 5),
    (ros, 5),
    (packages, 60),
    (extras, 5),
    (folders, 30),
    (sockets, 10),
    (programs, 60),
    (graph, 10),
    (limits, 5),
    (isolation, 60),
    (variables, 5),
)
"""In the order of the report, with the seconds that each may take."""
