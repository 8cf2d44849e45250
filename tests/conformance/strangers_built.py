"""Builds the packages of strangers' public repositories, with ours and with the real colcon, and compares.

    python -m tests.conformance.strangers_built --sources FOLDER [--real COLCON] [--clone] [--show] [WORD…]

The repositories are those of `strangers.json` at its commits; FOLDER has checkouts (see `checkouts.py`; `--clone` fetches what is
missing). A WORD chooses repositories by a part of `owner/name`. Of a name that a repository has twice the first package counts.

Ours builds every package plain and then linked (`--symlink-install`); after each no source may be changed, lost or new. With
`--real` the Python packages are built plain by the real colcon too: equal are a build's end, and every path of the install tree
but shells' scripts and metadata. This runs the `setup.py` of strangers.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import sys
import tempfile
from collections import Counter
from pathlib import Path

from tests.conformance.checkouts import Missing, extract
from tests.workspace.compare_shapes import build_all, install_tree
from tests.workspace.shapes import changes, snapshot

INPUTS = Path(__file__).with_name("strangers.json")
OURS = str(Path(sys.executable).with_name("day6-tui"))


def packages(tree: Path) -> dict[str, Path]:
    """Return the packages of a repository: name -> folder."""
    found: dict[str, Path] = {}
    for manifest in sorted(tree.rglob("package.xml")):
        name = re.search(r"<name>\s*([\w.-]+)\s*</name>", manifest.read_text(encoding="utf-8", errors="replace"))
        if name and not any(folder in manifest.parents for folder in found.values()):
            found.setdefault(name[1], manifest.parent)
    return found


def is_python(package: Path) -> bool:
    text = (package / "package.xml").read_text(encoding="utf-8", errors="replace")
    return "<build_type>ament_python</build_type>" in text and (package / "setup.py").is_file()


def build(command: list[str], workspace: Path, names: list[str], options: list[str]) -> dict[str, str]:
    """Build packages of a workspace; return how each ended."""
    env = {name: value for name, value in os.environ.items() if not name.startswith(("COLCON", "AMENT", "PYTHON"))}
    env["PATH"] = f"{Path(command[0]).parent}{os.pathsep}{env['PATH']}"
    return build_all(
        [*command, "build", "--continue-on-error", *options], workspace, env, names, workspace / "told.txt"
    )


def main() -> int:
    """Build everything, print a line for each repository and what differs; the status says whether anything does."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", type=Path, required=True, help="folder with checkouts")
    parser.add_argument("--clone", action="store_true", help="clone what is missing there")
    parser.add_argument("--real", metavar="COLCON", help="the real colcon")
    parser.add_argument("--show", action="store_true", help="print paths that differ")
    parser.add_argument("words", nargs="*", help="parts of names of repositories (default: all)")
    chosen = parser.parse_args()
    count: Counter[str] = Counter()
    for each in json.loads(INPUTS.read_text(encoding="utf-8"))["repositories"]:
        repository = each["repository"]
        if chosen.words and not any(word in repository for word in chosen.words):
            continue
        with tempfile.TemporaryDirectory() as name:
            place = Path(name)
            try:
                tree = extract(repository, each["commit"], chosen.sources, place / "source", clone=chosen.clone)
            except Missing as error:
                print(f"-- {error}", flush=True)
                continue
            found = packages(tree)
            if not found:
                continue
            here = compare(repository, found, place, chosen.real, chosen.show)
        print(f"   {repository}: {', '.join(f'{number} {what}' for what, number in here.items())}", flush=True)
        count += Counter({**here, "repositories": 1})
    print(f"{count['repositories']} repositories, {count['packages']} packages, built plain and linked:")
    print(f"{count['sources changed']} sources changed")
    if chosen.real:
        print(f"{count['install trees equal']} of {count['Python packages']} install trees of Python packages equal")
    return int(
        count["sources changed"] > 0 or count["install trees equal"] < count["Python packages"] * bool(chosen.real)
    )


def compare(repository: str, found: dict[str, Path], place: Path, real: str | None, show: bool) -> dict[str, int]:
    """Build the packages of one repository; return what is counted."""
    workspaces = {"ours": place / "ours", "linked": place / "linked", "real": place / "real"}
    for workspace in workspaces.values():
        for name, folder in found.items():
            shutil.copytree(folder, workspace / "src" / name)
    counted = {"packages": len(found), "sources changed": 0}
    ends: dict[str, dict[str, str]] = {}
    for what, options in (("ours", []), ("linked", ["--symlink-install"])):
        before = snapshot(workspaces[what] / "src")
        ends[what] = build([OURS, "colcon"], workspaces[what], list(found), options)
        for line in changes(before, snapshot(workspaces[what] / "src")):
            counted["sources changed"] += 1
            print(f"!= {repository} {what}: source {line}")
    python = [name for name, folder in found.items() if is_python(folder)]
    if real is not None and python:
        ends["real"] = build([real], workspaces["real"], python, [])
        counted |= {"Python packages": len(python), "install trees equal": 0}
        for name in python:
            ended = [ends[what].get(name, "not built") for what in ("real", "ours")]
            trees = [install_tree(workspaces[what] / "install" / name, workspaces[what]) for what in ("real", "ours")]
            # What is left of a build that failed is nobody's.
            if ended[0] == ended[1] and (trees[0] == trees[1] or ended[0] == "Failed"):
                counted["install trees equal"] += 1
                continue
            print(f"!= {repository} {name}: {ended[0]}, ours {ended[1]}")
            for side, only in (("real", set(trees[0]) - set(trees[1])), ("ours", set(trees[1]) - set(trees[0]))):
                print(*(f"      only {side}: {path}" for path in sorted(only) if show), sep="\n")
    return counted


if __name__ == "__main__":
    raise SystemExit(main())
