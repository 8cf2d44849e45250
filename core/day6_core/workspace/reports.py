"""The output of `colcon list`, `info`, `graph`, `extensions` and `version-check`."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path

from day6_core.workspace.events import Console
from day6_core.workspace.handlers import HANDLERS
from day6_core.workspace.order import Planned

_COLOURS = {"build": "#0000ff", "run": "#ff0000", "test": "#d2b48c"}


def list_packages(planned: list[Planned], args: Namespace, console: Console) -> int:
    """Run `colcon list`; returns the exit status."""
    if obsolete := _obsolete(args):
        console.err(f"{obsolete}\n")
        return 1
    if not args.topological_order:
        planned = sorted(planned, key=lambda each: each.package.name)
    lines = []
    for each in planned:
        package = each.package
        if each.selected:
            whole = f"{package.name}\t{package.shown}\t({package.type})"
            lines.append(package.name if args.names_only else package.shown if args.paths_only else whole)
    if not args.topological_order:
        lines.sort()
    console.out("".join(f"{line}\n" for line in lines))
    return 0


def _obsolete(args: Namespace) -> str:
    """Return what is said of the options of `colcon list` that became `colcon graph`, '' if none is given."""
    dot = [
        f" --{name.replace('_', '-')}"
        for name in ("dot_cluster", "dot_include_skipped")
        if getattr(args, f"topological_graph_{name}")
    ]
    legend = " --legend" if args.topological_graph_legend else ""
    if args.topological_graph or args.topological_graph_dot:
        further = "".join(dot) if args.topological_graph_dot else " --density" if args.topological_graph_density else ""
        if args.topological_graph:
            return (
                f"The list options --topological-graph / -g are obsolete, instead use `colcon graph{further}{legend}`"
            )
        return f"The list option --topological-graph-dot is obsolete, instead use `colcon graph --dot{further}{legend}`"
    if args.topological_graph_density:
        return "The option --topological-graph-density must be used together with --topological-graph"
    if legend:
        return "The option --topological-graph-legend must be used  with either --topological-graph or --topological-graph-dot"
    return (
        f"The option --topological-graph-{dot[0][3:]} must be used together with --topological-graph-dot" if dot else ""
    )


def info(planned: list[Planned], args: Namespace, console: Console) -> int:
    """Run `colcon info`; returns the exit status."""
    if args.package_names:
        names = {each.package.name for each in planned}
        unknown = [name for name in args.package_names if name not in names]
        for name in unknown:
            console.err(f"Package '{name}' not found\n")
        planned = [each for each in planned if each.package.name in args.package_names]
        if not planned:
            return 1
    if not planned:
        console.err("No packages found\n")
        return 1
    for each in sorted(planned, key=lambda each: each.package.name):
        package = each.package
        if not each.selected:
            continue
        lines = [f"path: {package.shown}", f"  type: {package.type}", f"  name: {package.name}"]
        known = dict(package.meta.options)
        if package.manifest is not None:
            known |= {"maintainers": package.manifest.maintainers} if package.manifest.maintainers else {}
            known["version"] = package.manifest.version
        if package.manifest is not None or package.dependencies():
            lines.append("  dependencies:")
            lines += [
                f"    {category}: {' '.join(sorted(set(names)))}" for category, names in sorted(package.depends.items())
            ]
        if package.meta.hooks:
            lines.append(f"  hooks: {' '.join(package.meta.hooks)}")
        if known:
            lines += ["  metadata:", *(f"    {key}: {known[key]}" for key in sorted(known))]
        console.out("\n".join(lines) + "\n")
    return 0


def graph(planned: list[Planned], args: Namespace, console: Console) -> int:
    """Run `colcon graph`: print a triangle of marks, or DOT; returns the exit status."""
    shown = [each for each in planned if each.selected]
    if args.dot:
        console.out("\n".join(_dot(planned, args)) + "\n")
        return 0
    if args.legend:
        console.out(
            "+ marks when the package in this row can be processed\n"
            "* marks a direct dependency from the package indicated by the + in the same column to the package in this row\n"
            ". marks a transitive dependency\n\n"
        )
    width = max((len(each.package.name) for each in shown), default=0) + 2
    lines = [each.package.name.ljust(width) for each in shown]
    empty = 0
    for column, each in enumerate(shown):
        direct = each.package.dependencies()
        for row, other in enumerate(shown):
            name = other.package.name
            mark = "+" if row == column else "*" if name in direct else "." if name in each.needs else " "
            empty += mark == " "
            lines[row] += mark
    if args.density:
        cells = len(lines) * (len(lines) - 1)
        console.out(f"dependency density {200.0 * (1.0 - (empty / cells if cells else 1.0)):.2f} %\n\n")
    console.out("".join(f"{line}\n" for line in lines))
    return 0


def _dot(planned: list[Planned], args: Namespace) -> list[str]:
    nodes = [each for each in reversed(planned) if each.selected or args.dot_include_skipped]
    by_name = {each.package.name: each for each in planned}
    names = {each.package.name for each in nodes}
    lines = ["digraph graphname {", *_dot_nodes(nodes, args)]
    direct: dict[tuple[Planned, str], set[str]] = {}
    for each in nodes:
        for kind, dependencies in each.package.depends.items():
            for name in sorted(names.intersection(dependencies)):
                direct.setdefault((each, name), set()).add(kind)
    indirect: dict[tuple[Planned, str], set[str]] = {}
    for each in (each for each in nodes if each.selected):
        for kind, dependencies in each.package.depends.items():
            for between in (by_name[name] for name in dependencies if name in by_name and name not in names):
                for name in between.needs:
                    if name in names and (each, name) not in direct:
                        indirect.setdefault((each, name), set()).add(kind)
    for style, edges in (("", direct), (', style="dashed"', indirect)):
        for (each, name), kinds in edges.items():
            pale = "" if each.selected and by_name[name].selected else "77"
            colours = ":".join(f"{colour}{pale}" for kind, colour in _COLOURS.items() if kind in kinds)
            lines.append(f'  "{each.package.name}" -> "{name}" [color="{colours}"{style}];')
    if args.legend:
        lines += ["  subgraph cluster_legend {", "    color=gray", '    label="Legend";', "    margin=0;"]
        lines.append('    node [label="", shape=none];')
        before = "_legend_first"
        for kind, colour in _COLOURS.items():
            lines.append(f'    {before} -> _legend_{kind} [label="{kind} dep.", color="{colour}"];')
            before = f"_legend_{kind}"
        lines.append(f'    {before} -> _legend_last [label="indirect dep.", style="dashed"];')
        ranks = [
            f"      {name};" for name in ("_legend_first", *(f"_legend_{kind}" for kind in _COLOURS), "_legend_last")
        ]
        lines += ["    {", "      rank=same;", *ranks, "    }", "  }"]
    return [*lines, "}"]


def _dot_nodes(nodes: list[Planned], args: Namespace) -> Iterator[str]:
    """Yield the packages, with `--dot-cluster` in a frame for each folder."""
    folders = [os.path.dirname(each.package.path) for each in nodes]
    one_drive = len({os.path.splitdrive(folder)[0] for folder in folders}) == 1
    common = os.path.commonpath(folders) if args.dot_cluster and one_drive else ""
    clusters: dict[str, list[Planned]] = {}
    for each, folder in zip(nodes, folders, strict=True):
        clusters.setdefault(Path(os.path.relpath(folder, common)).as_posix() if common else ".", []).append(each)
    for number, (folder, members) in enumerate(clusters.items()):
        framed = folder != "."
        if framed:
            yield from (f"  subgraph cluster_{number} {{", f'    label = "{folder}";')
        for each in members:
            grey = '[color = "gray" fontcolor = "gray"]' if not each.selected else ""
            yield f'{"    " if framed else "  "}"{each.package.name}"{grey};'
        if framed:
            yield "  }"


def extensions(console: Console) -> int:
    """Run `colcon extensions`: list the extensions of this colcon; returns the exit status."""
    console.out("colcon_core.event_handler\n")
    console.out("".join(f"  {name}: {each.summary}\n" for name, each in HANDLERS.items()))
    console.out("colcon_core.executor\n")
    console.out("  parallel: Process multiple packages in parallel\n  sequential: Process one package at a time\n")
    console.out("colcon_core.task.build\n")
    for kind, text in (
        ("python", "Build Python packages"),
        ("ros.ament_cmake", "Build ROS packages with the build type 'ament_cmake' (interfaces only)"),
        ("ros.ament_python", "Build ROS packages with the build type 'ament_python'"),
    ):
        console.out(f"  {kind}: {text}\n")
    return 0


def version_check(console: Console) -> int:
    """Run `colcon version-check`: print the version of day6-tui, without using the network; returns the exit status."""
    try:
        version = metadata.version("day6-tui")
    except metadata.PackageNotFoundError:
        version = "(not installed)"
    console.out(f"day6-tui {version}: colcon is part of it; nothing was compared with PyPI\n")
    return 0
