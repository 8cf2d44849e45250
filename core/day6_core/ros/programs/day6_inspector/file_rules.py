"""Rules about workspaces, parameter files and what terminals know of them."""

from __future__ import annotations

import shlex
from collections.abc import Iterator

from day6_core.facts.names import nearest
from day6_core.facts.workspaces import Package, Workspace, sourced_prefixes
from day6_core.ros.distribution import setup_script
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.sight import looks_at


@looks_at("packages")
def of_files(facts: Facts) -> Iterator[Finding]:
    """Yield what is wrong with the workspaces."""
    if facts.files is None:
        return
    for workspace in facts.files.workspaces:
        yield from _workspace(facts, workspace)
    for folder in facts.files.strays:
        then = f"rm -r {' '.join(shlex.quote(str(folder / each)) for each in ('build', 'install', 'log'))}"
        yield finding("warning", "stray_build", folder=folder, then=then)
    for number, variable, entry in facts.files.gone:
        yield finding(
            "warning",
            "gone",
            number=number,
            variable=variable,
            entry=entry,
            then=f"unset {variable}; source {setup_script()}",
        )
    for place in facts.files.unreadable:
        yield finding("info", "unreadable", what=place)
    yield from _parameters(facts)


def _workspace(facts: Facts, workspace: Workspace) -> Iterator[Finding]:
    build = f"cd {shlex.quote(str(workspace.folder))} && colcon build"
    for name, one, other in workspace.twice:
        folders = ", ".join(str(each.relative_to(workspace.folder)) for each in (one, other))
        then = f"touch {shlex.quote(str(other / 'COLCON_IGNORE'))}"
        yield finding("error", "duplicates", package=name, folders=folders, then=then)
    for inner, outer in workspace.inner:
        then = f"mv {shlex.quote(str(inner))} {shlex.quote(str(workspace.folder / 'src'))}"
        yield finding("warning", "inner_package", inner=inner.name, outer=outer.name, then=then)
    for package in workspace.packages:
        yield from _package(package, build)
    built = [package.name for package in workspace.packages if package.built]
    terminals = facts.terminals or ()
    sourced = (prefix for each in terminals for prefix in sourced_prefixes(each.variables))
    if built and terminals and not any(prefix.is_relative_to(workspace.install) for prefix in sourced):
        then = f"source {shlex.quote(str(workspace.install / 'setup.bash'))}"
        yield finding("info", "nowhere_sourced", packages=", ".join(built), then=then)


def _package(package: Package, build: str) -> Iterator[Finding]:
    setup = package.folder / "setup.py"
    edit = f"nano {shlex.quote(str(setup))}"
    for entry in package.entry_points:
        if entry.flaw == "py":
            right = entry.module.replace("/", ".").removesuffix(".py")
            said = {"package": package.name, "entry": entry.name, "wrong": entry.module, "right": right}
            yield finding("error", "entry_py", **said, then=edit)
        elif entry.flaw == "module":
            yield finding(
                "error", "entry_module", package=package.name, entry=entry.name, module=entry.module, then=edit
            )
        elif entry.flaw == "function":
            said = {"package": package.name, "entry": entry.name, "module": entry.module, "function": entry.function}
            file = package.folder.joinpath(*entry.module.split(".")).with_suffix(".py")
            yield finding("error", "entry_function", **said, then=f"nano {shlex.quote(str(file))}")
        elif entry.flaw == "form":
            yield finding("error", "entry_form", package=package.name, entry=entry.name, then=edit)
    if package.in_bin:
        then = f"nano {shlex.quote(str(package.folder / 'setup.cfg'))}"
        yield finding("error", "no_setup_cfg", package=package.name, then=then)
    if package.changed:
        first, rest = package.changed[0], len(package.changed) - 1
        files = f"{first} (+{rest})" if rest else first
        yield finding("warning", "not_rebuilt", package=package.name, files=files, then=build)
    elif package.not_installed:
        where = package.install_script
        said = {"file": package.not_installed[0], "package": package.name, "where": where.name}
        yield finding("warning", "launch_not_installed", **said, then=f"nano {shlex.quote(str(where))}")


def _parameters(facts: Facts) -> Iterator[Finding]:
    assert facts.files is not None
    for file in facts.files.parameters:
        edit = f"nano {shlex.quote(str(file.path))}"
        if file.problem:
            yield finding("error", "parameter_file", file=file.path.name, reason=file.problem, then=edit)
        elif file.keys and facts.nodes and not any(_fits(key, facts.nodes) for key in file.keys):
            keys = ", ".join(file.keys)
            nodes = nearest(file.keys[0], facts.nodes, 0.4) or ", ".join(dict.fromkeys(facts.nodes))
            yield finding("warning", "parameter_keys", file=file.path.name, keys=keys, nodes=nodes, then=edit)
        elif not file.keys:
            yield finding("warning", "parameter_nothing", file=file.path.name, then=edit)


def _fits(key: str, nodes: tuple[str, ...]) -> bool:
    """Whether a key of a parameter file means one of the nodes (`*`: one part of a name, `**`: any number)."""
    if "*" not in key:
        return key in nodes or f"/{key.strip('/')}" in nodes
    import re

    parts = (
        ".*" if part == "**" else "[^/]+" if part == "*" else re.escape(part) for part in key.strip("/").split("/")
    )
    pattern = "/" + "/?".join(parts) if "**" in key else "/" + "/".join(parts)
    return any(re.fullmatch(pattern, node) for node in nodes)
