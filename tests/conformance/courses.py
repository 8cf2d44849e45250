"""By hand: builds other people's course repositories with a plain `colcon build`, from each place where their reader would.

`python -m tests.conformance.courses FOLDER…`, where each folder is the checkout of one repository; what is too large to be had
may be an empty file. A `setup.py` is a program: run it without network, and where it can damage nothing (bwrap).
"""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.workspace.workshop import Workshop

_BUILT = {"build", "install", "log"}
_FAILED = re.compile(r"^  .* (?:failed|aborted): .*$|^.*ERROR:colcon.*$", re.MULTILINE)


def roots(repository: Path) -> Iterator[tuple[Path, str]]:
    """Yield the workspaces of a repository, and where in `~/ros2_ws` each is copied: '.' or, without a folder src, 'src/NAME'."""
    inside, outside = dict[Path, None](), list[Path]()
    for manifest in sorted(repository.rglob("package.xml")):
        package = manifest.parent
        if any(part in _BUILT or part[0] == "." for part in package.relative_to(repository).parts):
            continue
        above = [each for each in (*package.parents,)[::-1] if each.is_relative_to(repository)]
        root = next((each for each in above if package.is_relative_to(each / "src") and not _is_package(each)), None)
        if root is None:
            outside.append(package)
        else:
            inside[root] = None
    yield from ((root, ".") for root in inside)
    names = [_name(package) for package in outside]
    if len(set(names)) == len(names) and not inside:
        yield from ((repository, f"src/{repository.name}") for _ in outside[:1])
    else:  # chapters that each have a package of the same name
        for name in dict.fromkeys(package.relative_to(repository).parts[0] for package in outside):
            yield repository / name, f"src/{name}"


def _is_package(folder: Path) -> bool:
    return (folder / "package.xml").is_file()


def _name(package: Path) -> str:
    found = re.search(r"<name>\s*([^<\s]+)", (package / "package.xml").read_text(encoding="utf-8", errors="replace"))
    return found[1] if found else package.name


def build(root: Path, place: str) -> tuple[int, str]:
    """Return the status of `colcon build`, and what it says of what failed."""
    with tempfile.TemporaryDirectory() as folder:
        workshop = Workshop(Path(folder, "home"))
        try:
            shutil.copytree(root, workshop.workspace / place, symlinks=True, dirs_exist_ok=True)
            done = workshop.run("colcon build", workshop.terminal(workshop.workspace))
        finally:
            workshop.close()
    return done.status, "; ".join(" ".join(line.split()) for line in _FAILED.findall(done.out + done.err))


def main(folders: list[str]) -> None:
    """Print each place that doesn't finish, then the sums."""
    whole = finished = places = 0
    for folder in folders:
        results = [(root, *build(root, place)) for root, place in roots(Path(folder))]
        for root, status, text in results:
            if status:
                print(f"{root}: {text}", flush=True)
        places += len(results)
        finished += sum(not status for _, status, _ in results)
        whole += bool(results) and not any(status for _, status, _ in results)
    print(f"{whole} of {len(folders)} repositories finish, {finished} of {places} workspaces in them")


if __name__ == "__main__":
    main(sys.argv[1:])
