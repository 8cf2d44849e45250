"""Builds the shapes of packages with the real colcon and with ours, and prints what differs; started by hand.

    python -m tests.workspace.compare_shapes --real /path/of/colcon [SHAPE …]

For each step: which packages were built, what became of the sources, the install trees, and what Python then imports.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.workspace.shapes import PYTHON, STEPS, changes, lay_out, snapshot

_LEFT_OUT = ("setup.", "local_setup.", "_local_setup", "COLCON_IGNORE", ".colcon_install_layout")
_IMPORTED = """\
import importlib, os, sys
found = importlib.import_module(sys.argv[1]).__file__
print(found, sorted(set(os.listdir(os.path.dirname(found))) - {"__pycache__"}))
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--real", required=True, help="the real colcon")
    parser.add_argument(
        "--keep", type=Path, help="build in this folder; what was built there before is not built again"
    )
    parser.add_argument("shapes", nargs="*", default=list(PYTHON))
    options = parser.parse_args()
    base = options.keep or Path(tempfile.mkdtemp(prefix="day6-shapes-"))
    ours = [str(Path(sys.executable).with_name("day6-tui")), "colcon"]
    told = {}
    for name, command in (("real", [options.real]), ("ours", ours)):
        kept = base / f"{name}.json"
        if not kept.exists():
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_text(json.dumps(played(command, base / name, options.shapes)), encoding="utf-8")
        told[name] = json.loads(kept.read_text(encoding="utf-8"))
    for (step, (option, later)), *both in zip(enumerate(STEPS), told["real"], told["ours"], strict=True):
        print(f"== {step}: colcon build {option}{' (later)' if later else ''}")
        for shape in options.shapes:
            for what in both[0][shape]:
                real, own = both[0][shape][what], both[1][shape][what]
                if what == "sources":
                    for name, lines in (("real", real), ("ours", own)):
                        for line in lines:
                            print(f"{shape}: {name}: source {line}")
                elif real != own:
                    print(f"{shape}: {what}: real {_without(real, own)}, ours {_without(own, real)}")


def build_all(words: list[str], folder: Path, env: dict[str, str], names: list[str], told: Path) -> dict[str, str]:
    """Build until each package had its turn: an exception of one ends the real colcon, whatever --continue-on-error says."""
    told.write_text("", encoding="utf-8")
    results: dict[str, str] = {}
    while left := [name for name in names if name not in results]:
        command = [*words, "--base-paths", *(f"src/{name}" for name in left)]
        done = subprocess.run(
            command, cwd=folder, env=env, capture_output=True, text=True, errors="replace", check=False
        )
        with told.open("a", encoding="utf-8") as file:
            file.write(done.stdout + done.stderr)
        ended = re.findall(r"(?m)^(Finished|Failed|Aborted) +<<< (\S+)", done.stdout + done.stderr)
        results.update((name, word) for word, name in ended)
        if not ended:
            break
    return results


def _without(value: object, other: object) -> object:
    if isinstance(value, list) and isinstance(other, list):
        return [each for each in value if each not in other]
    return value


def played(command: list[str], folder: Path, names: list[str]) -> list[dict[str, dict[str, object]]]:
    """Return for each step and package: status, sources, installed, imported."""
    folder.mkdir(parents=True)
    shapes = {name: PYTHON[name] for name in names}
    steps = []
    for option, later in STEPS:
        lay_out(folder / "src", shapes, later)
        before = snapshot(folder)
        words = [*command, "build", "--continue-on-error", *option.split()]
        env = {name: value for name, value in os.environ.items() if not name.startswith(("COLCON", "AMENT", "PYTHON"))}
        env["PATH"] = f"{Path(command[0]).parent}{os.pathsep}{env['PATH']}"
        results = build_all(words, folder, env, list(names), folder / f"step{len(steps)}.txt")
        kept = ("src/", "src")
        lost = [line for line in changes(before, snapshot(folder)) if line.startswith(kept)]
        steps.append({name: {"status": results.get(name), **_state(folder, name, lost)} for name in names})
    return steps


def _state(folder: Path, name: str, lost: list[str]) -> dict[str, object]:
    prefix = folder / "install" / name
    library = next(prefix.glob("lib/python3*/site-packages"), prefix)
    env = {"PYTHONPATH": os.pathsep.join(map(str, (folder / "build" / name / "src", folder / "build" / name, library)))}
    if not (folder / "build" / name / "setup.py").is_symlink():
        env["PYTHONPATH"] = str(library)
    words = [sys.executable, "-BSc", _IMPORTED, name]
    done = subprocess.run(words, env=env, cwd="/", capture_output=True, text=True, check=False)
    return {
        "sources": [line for line in lost if line.startswith(f"src/{name}/")],
        "installed": install_tree(prefix, folder),
        "imported": done.stdout.replace(str(folder), "")
        if not done.returncode
        else done.stderr.strip().splitlines()[-1],
    }


def install_tree(prefix: Path, folder: Path) -> list[str]:
    """Return the paths below an install prefix, links with what they lead to; without what colcon makes for shells."""
    found = []
    for current, folders, files in os.walk(prefix):
        folders[:] = sorted(each for each in folders if each != "__pycache__" and "egg-info" not in each)
        for each in (*folders, *sorted(files)):
            path = Path(current, each)
            shown = path.relative_to(prefix).as_posix().replace("python3.11", "python3")
            to = f" -> {os.path.realpath(path).removeprefix(str(folder))}" if path.is_symlink() else ""
            if (to or path.is_file()) and not each.startswith(_LEFT_OUT) and "share/colcon-core" not in shown:
                found.append(shown + to)
    return sorted(each for each in found if ("/hook/" not in each and "/package." not in each) or "package.xml" in each)


if __name__ == "__main__":
    main()
