"""Lookers that look at files and at the variables of the terminal: workspaces, packages, programs, paths."""

from __future__ import annotations

import os
import re
import shlex
import sys
from itertools import chain
from pathlib import Path

from day6_core.advice import known
from day6_core.advice.foreign_modules import NEXT, PIP, family_of
from day6_core.advice.lookers_line import of_slip
from day6_core.advice.looking import Found, Situation, found, looker
from day6_core.advice.rules import apt_name, cause_of, own_module
from day6_core.advice.typed import slip_of_command
from day6_core.facts.folders import files_in, names_in
from day6_core.facts.names import CLOSE, nearest
from day6_core.facts.setup_file import read_setup
from day6_core.facts.workspaces import (
    Package,
    Workspace,
    entries_of_wrong_form,
    executables_in,
    find_package,
    names_file,
    packages_lacking_comma,
    refused_manifests,
    sourced_prefixes,
    why_unknown,
    workspaces_around,
)
from day6_core.interfaces import registry
from day6_core.language import language_of
from day6_core.places import meant_in
from day6_core.ros.differences import has_interface, has_package
from day6_core.ros.distribution import setup_script

MOST_FILES = 2000
"""Files below a folder that are looked at."""


@looker
def python(scene: Situation) -> Found | None:
    """The rules for exceptions: slips in names, modules that are not sourced, Chinese punctuation."""
    if scene.fault is None:
        return None
    text = cause_of(scene.fault, scene.around, language_of(scene.variables))
    run = re.search(r"(?:[Rr]un:|先运行：|可以运行：) ?(.+)$", text)
    return found("said", run[1] if run is not None else "", text=text) if text else None


@looker
def own_python(scene: Situation) -> Found | None:
    """A file of the pupil's that Python finds in place of its own module, or of ROS's."""
    name = own_module(scene.said, scene.around, scene.fault.file if scene.fault is not None else "")
    if not name:
        return None
    key = "module.own_python" if name in sys.stdlib_module_names else "module.own_file"
    return found(key, f"mv {name}.py my_{name}.py", file=f"{name}.py", name=name)


@looker
def foreign(scene: Situation) -> Found | None:
    """A package of ROS that is not here: what it is for, and what can do its part; for one of ours, whether ROS is sourced."""
    name = scene.value("name").partition(".")[0]
    if (Path(registry.OWN_SHARE) / name).is_dir():
        return ros_itself(scene) if has_package(name) else None
    family = family_of(name)
    if (
        not family
        or name in PIP
        or name in known_packages(scene)
        or why_unknown(name, scene.variables, scene.cwd) is not None
    ):
        return None
    return found(f"foreign.{family}", NEXT.get(family, ""), name=name, apt=apt_name(name))


@looker
def ros_itself(scene: Situation) -> Found | None:
    """Whether ROS itself is sourced in this terminal."""
    if scene.variables.get("ROS_DISTRO") or scene.variables.get("AMENT_PREFIX_PATH"):
        return None
    return found("ros_not_sourced", f"source {setup_script()}")


@looker
def package(scene: Situation) -> Found | None:
    """A package that is built and not sourced, or lies in `src`, or has a name that is nearly this one."""
    name, words = scene.value("name"), scene.words()
    if words[:2] == ["ros2", "run"] and len(words) > 3 and name == words[2] in _executables(words[3], scene):
        turned = shlex.join([*words[:2], words[3], name, *words[4:]])
        return found("run.turned", turned, name=name, package=words[3])
    state = _of_the_workspace(name, scene)
    if state is not None:
        return state
    names = known_packages(scene)
    if name in names:
        return found("package.now_known", "", name=name)
    near = nearest(name, names)
    return found("package.near", _again(scene, name, near), name=name, near=near) if near else None


def _of_the_workspace(name: str, scene: Situation) -> Found | None:
    """Whether a package is built and not sourced, or not even built."""
    if not name.isidentifier():
        return None
    unknown = why_unknown(name, scene.variables, scene.cwd)
    if unknown is None:
        return None
    folder = short(unknown.folder, scene)
    if unknown.because == "refused":
        return found(
            "package.refused", f"nano {short(unknown.folder / 'package.xml', scene)}", name=name, folder=folder
        )
    if unknown.because == "not_sourced":
        source = f"source {short(unknown.folder / 'setup.bash', scene)}"
        return found("package.not_sourced", source, name=name, install=folder)
    return found(f"package.{unknown.because}", _build(unknown.workspace, name, scene), name=name, folder=folder)


@looker
def executable(scene: Situation) -> Found | None:
    """A program that its package does not have: the name is nearly another's, setup.py does not name it, or it was not built."""
    words = scene.words()
    if words[:2] != ["ros2", "run"]:
        return None
    operands = [word for word in words[2:] if not word.startswith("-")]
    if len(operands) < 2:
        return None
    package, name = operands[:2]
    installed = _executables(package, scene)
    near = name.removesuffix(".py") if name.removesuffix(".py") in installed else ""
    near = near or nearest(name, installed)
    lies = find_package(package, workspaces_around(scene.variables, scene.cwd))
    if lies is None:
        if near:
            return found("executable.near", shlex.join(["ros2", "run", package, near]), name=name, near=near)
        has = ", ".join(installed)
        return found("executable.has", f"ros2 pkg executables {package}", package=package, names=has) if has else None
    source = lies[1]
    setup, edit = source.folder / "setup.py", f"nano {short(source.folder / 'setup.py', scene)}"
    said = read_setup(source.folder)
    if said.comma:
        return _comma(source.folder, said.comma, scene)
    if name in said.programs:
        build = _build(lies[0].folder, package, scene)
        return found("executable.not_built", build, name=name, package=package)
    if near:
        return found("executable.near", shlex.join(["ros2", "run", package, near]), name=name, near=near)
    if line := source.lacking_entry(name):
        return found("executable.no_entry", edit, name=name.removesuffix(".py"), setup=setup, line=f"{line},")
    if said.programs:
        return found("executable.others", "", package=package, names=", ".join(sorted({*said.programs})))
    return found("executable.none", edit, setup=setup)


def _comma(package: Path, line: int, scene: Situation) -> Found:
    setup = short(package / "setup.py", scene)
    return found("setup.comma", f"nano {setup}", setup=setup, line=line)


@looker
def setup_comma(scene: Situation) -> Found | None:
    """A comma that is missing between two entry points of a setup.py, or an entry point that is written in another way."""
    workspaces = list(workspaces_around(scene.variables, scene.cwd))
    if (lacking := next(packages_lacking_comma(workspaces), None)) is not None:
        return _comma(*lacking, scene)
    if (odd := next(entries_of_wrong_form(workspaces), None)) is None:
        return None
    setup = short(odd[0] / "setup.py", scene)
    return found("setup.form", f"nano {setup}", setup=setup, entry=odd[1])


@looker
def launch_file(scene: Situation) -> Found | None:
    """A launch file that lies in `src` but is not installed, or whose name is nearly this one."""
    name, package, share = scene.value("name"), scene.value("package"), Path(scene.value("share"))
    lies = find_package(package, workspaces_around(scene.variables, scene.cwd))
    cause = of_package_file(name, lies, scene) if lies is not None else None
    if cause is not None:
        return cause
    names = [
        path.name
        for path in files_in(share, most=MOST_FILES)
        if path.suffix in (".py", ".xml", ".yaml", ".yml") and "launch" in path.name
    ]
    near = nearest(name, names)
    if near:
        return found("launch.near", shlex.join(["ros2", "launch", package, near]), name=name, near=near)
    return found("launch.others", "", package=package, names=", ".join(sorted(set(names)))) if names else None


def of_package_file(name: str, lies: tuple[Workspace, Package], scene: Situation) -> Found | None:
    """A file of a package's sources that is not among its installed ones: setup.py does not name it, or it was not built."""
    workspace, source = lies
    there = source.file_called(name)
    if there is None:
        return None
    file = source.install_script
    if names_file(file, there):
        return found("launch.not_rebuilt", _build(workspace.folder, source.name, scene), name=name)
    key, place = "launch.data_files" if source.python else "launch.install", there.rpartition("/")[0] or "."
    return found(key, f"nano {short(file, scene)}", name=name, file=short(file, scene), place=place)


@looker
def path(scene: Situation) -> Found | None:
    """A path that is not there: the home of somebody else, another place, nearly another name, a folder that is missing."""
    name = scene.value("name").strip("'\"")
    if scene.command.startswith(name) and not (scene.cwd / name.partition("/")[0]).exists():
        slip = slip_of_command(name, scene.command, scene.commands)
        if slip is not None:
            return of_slip(slip)
    home = re.match(r"/home/[^/]+((?:/[^/]+)*)/?$", name)
    if home is not None and not Path(name).exists() and not str(scene.home).startswith(f"/home/{name.split('/')[2]}"):
        rest = home[1]
        right = f"~{rest}"
        again = _again(scene, name, right) if (scene.home / rest.lstrip("/")).exists() else ""
        return found("home", again, wrong=name.removesuffix(rest) or name, right=right, rest=rest)
    whole = Path(os.path.normpath(scene.cwd / meant_in(scene.home, name)))
    if not name or whole.exists():
        return None
    parent = whole.parent
    if not parent.is_dir():
        gone = next((above for above in (parent, *parent.parents) if above.parent.is_dir()), parent)
        return found("path.no_folder", "", folder=gone, above=gone.parent)
    entries = names_in(parent)[:MOST_FILES]
    near = next((entry for entry in entries if entry.lower() == whole.name.lower()), "") or nearest(whole.name, entries)
    if near and len(whole.name) > 2:
        right = name.removesuffix(whole.name) + near if name.endswith(whole.name) else near
        return found("path.near", _again(scene, name, right), name=name, near=right)
    there = elsewhere(whole.name, scene)
    if there is not None:
        return found("path.elsewhere", f"cd {short(there.parent, scene)}", name=whole.name, place=there)
    return None


@looker
def not_executable(scene: Situation) -> Found | None:
    """A file that may not be run."""
    name = scene.value("name")
    whole = scene.cwd / name
    if whole.is_dir():
        return found("is_folder", shlex.join(["cd", name]), name=name)
    if whole.is_file() and not os.access(whole, os.X_OK):
        run = ["python3", name] if name.endswith(".py") else ["chmod", "+x", name]
        return found("not_executable", shlex.join(run), name=name)
    return None


@looker
def prefix_path(scene: Situation) -> Found | None:
    """A folder of an environment variable that is not there any more."""
    folder = Path(scene.value("path"))
    if folder.exists():
        return None
    install = next((above for above in (folder, *folder.parents) if above.name == "install"), None)
    if install is not None and (install.parent / "src").is_dir():
        return found("prefix.deleted", shlex.join(["unset", scene.value("variable")]), folder=folder)
    return found("prefix.gone", "", folder=folder)


@looker
def build_folder(scene: Situation) -> Found | None:
    """A build that was started in the folder `src`, or a workspace within a workspace."""
    if scene.cwd.name == "src":
        return found("folder.src", f"cd {short(scene.cwd.parent, scene)}", workspace=scene.cwd.parent)
    outer = next(
        (above for above in scene.cwd.parents if (above / "src").is_dir() and (above / "install").is_dir()), None
    )
    if outer is not None and (scene.cwd / "package.xml").is_file():
        return found("folder.package", f"cd {short(outer, scene)}", workspace=outer)
    workspace = scene.home / "ros2_ws"
    if any((workspace / "src").glob("*/package.xml")) and scene.cwd != workspace and not (scene.cwd / "src").is_dir():
        return found("folder.nothing", "cd ~/ros2_ws")
    return None


@looker
def manifests(scene: Situation) -> Found | None:
    """A package.xml that colcon does not take for one."""
    left_out = next(refused_manifests(scene.cwd), None)
    if left_out is None:
        return None
    manifest, reason = left_out
    edit = f"nano {short(manifest, scene)}"
    return found(f"manifest.{reason.because}", edit, file=short(manifest, scene), what=reason.what, line=reason.line)


@looker
def message_package(scene: Situation) -> Found | None:
    """A message type whose package is built and not sourced, or whose name is nearly another's."""
    whole = scene.value("type")
    if (file := re.search(r"/share/(\w+/\w+/\w+)\.\w+'?$", whole)) is not None:
        whole = file[1]
    if not whole:
        whole = next((word for word in scene.words() if re.fullmatch(r"\w+(?:/\w+)?/\w+|[A-Z]\w*", word)), "")
    if (dotted := re.fullmatch(r"(\w+)\.(msg|srv|action)\.(\w+)", whole)) is not None:
        near = "/".join(dotted.groups())
        return found("type.slashes", scene.with_word(whole, near), name=whole, near=near)
    if re.fullmatch(r"\w+", whole):
        return _type_of_name(whole, scene)
    package, _, kind = whole.partition("/")
    if not kind or not package.isidentifier():
        return None
    state = _of_the_workspace(package, scene)
    if state is not None:
        return state
    name = kind.rpartition("/")[2]
    exact = known.types_called(name, scene.variables)
    if exact and whole.count("/") == 1 and (three := [each for each in exact if each.startswith(f"{package}/")]):
        return found("type.parts", scene.with_word(whole, three[0]), name=whole, near=three[0])
    others = [each for each in exact if each != whole]
    if others and whole not in exact:
        near = others[0]
    else:
        types = sorted({f"{f.parent.parent.name}/{f.parent.name}/{f.stem}" for share in known.shares(scene.variables)
                        for f in share.glob(f"{package}/*/*.*") if f.parent.name in ("msg", "srv", "action")})  # fmt: skip
        types = list(filter(has_interface, types))
        near = nearest(whole, types, CLOSE)
        if near in ("", whole):
            return None
    return found("type.near", _again(scene, whole, near), name=whole, near=near)


def _type_of_name(name: str, scene: Situation) -> Found | None:
    """A type without its package: the one there is, or all of them."""
    exact = known.types_called(name, scene.variables) or known.types_called(
        name[:1].upper() + name[1:], scene.variables
    )
    exact = [each for each in exact if not each.startswith("test_msgs/")] or exact
    if len(exact) == 1:
        return found("type.whole", scene.with_word(name, exact[0]), name=name, near=exact[0])
    return found("type.several", "", name=name, types=", ".join(exact)) if exact else None


# -- what they share -------------------------------------------------------------------------------------------------------


def known_packages(scene: Situation) -> list[str]:
    """Return the packages that this terminal knows."""
    names = {path.parent.name for share in known.shares(scene.variables) for path in share.glob("*/package.xml")}
    return sorted(filter(has_package, names))


def _again(scene: Situation, wrong: str, right: str) -> str:
    """The line that was run with one name put right; '' if that cannot be done safely."""
    plain = shlex.quote(right.removeprefix("~")) == right.removeprefix("~") or right == "~"
    return scene.command.replace(wrong, right) if wrong and plain and scene.command.count(wrong) == 1 else ""


def _build(workspace: Path, package: str, scene: Situation) -> str:
    """The line that builds one package and makes it known here."""
    go = "" if workspace == scene.cwd else f"cd {short(workspace, scene)}; "
    return f"{go}colcon build --packages-select {shlex.quote(package)}; source install/setup.bash"


def short(place: Path, scene: Situation) -> str:
    """Return a path as one types it: from here, from home, or whole; quoted where that is needed."""
    for base, beginning in ((scene.cwd, ""), (scene.home, "~/")):
        if place != base and place.is_relative_to(base) and (beginning or base != scene.home):
            rest = place.relative_to(base).as_posix()
            return beginning + (rest if shlex.quote(rest) == rest else shlex.quote(rest))
    return "~" if place == scene.home else "." if place == scene.cwd else shlex.quote(str(place))


def elsewhere(name: str, scene: Situation) -> Path | None:
    """Return the one file of that name below home's workspace or this folder; None if there is none, or several."""
    if len(name) < 3 or "." not in name:
        return None
    roots = [root for root in (scene.cwd, scene.home / "ros2_ws" / "src", scene.home) if root.is_dir()]
    for root in roots:
        places = [
            each
            for each in files_in(root, most=MOST_FILES, hidden=True)
            if each.name == name and not {"build", "install", "log"} & {*each.parts}
        ]
        if places:
            return places[0] if len(places) == 1 else None
    return None


def _executables(package: str, scene: Situation) -> list[str]:
    from day6_core.ros.program_index import executables

    installed = (executables_in(prefix, package) for prefix in sourced_prefixes(scene.variables))
    return sorted({*executables(package), *chain.from_iterable(installed)})
