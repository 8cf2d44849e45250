"""Public repositories at fixed commits, the inputs of scripts here: found in a folder of checkouts, or cloned into it.

A checkout of `owner/name` is the folder `owner+name` (or `owner+name/repo`, or `owner/name`, bare or not) below the folder given.
Missing ones can be cloned; that needs git and a network. Nothing of them is ever copied into this repository.
"""

from __future__ import annotations

import subprocess
from pathlib import Path, PurePosixPath

HOST = "https://github.com"


class Missing(Exception):
    """A repository that is not there, or not at the commit asked for."""


def extract(repository: str, commit: str, sources: Path, into: Path, *, clone: bool = False) -> Path:
    """Write the files of a commit to the folder `into`; raise Missing where there is no such commit.

    Files that the checkout lacks (a partial clone) are left out, and so are links and submodules.
    """
    found = _checkout(repository, sources)
    if found is None and clone:
        found = sources / repository.replace("/", "+")
        _git("clone", "--quiet", "--no-checkout", f"{HOST}/{repository}", str(found))
    if found is None:
        raise Missing(f"{repository}: no checkout below {sources}")
    into.mkdir(parents=True, exist_ok=True)
    files: dict[str, tuple[str, str]] = {}
    for entry in (
        _git("-C", str(found), "ls-tree", "-r", "-z", commit).decode(errors="surrogateescape").split("\0")[:-1]
    ):
        mode, _, rest = entry.split(" ", 2)
        name, path = rest.split("\t", 1)
        if mode in ("100644", "100755") and ".." not in PurePosixPath(path).parts:
            files[path] = (mode, name)
    objects = _objects(found, {name for _, name in files.values()})
    for path, (mode, name) in files.items():
        if name in objects:
            file = into / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(objects[name])
            file.chmod(int(mode[3:], 8))
    return into


def _objects(checkout: Path, names: set[str]) -> dict[str, bytes]:
    """Return the contents of git's objects, as far as they are there."""
    answer = _git("-C", str(checkout), "cat-file", "--batch", data="\n".join(names).encode() + b"\n")
    found: dict[str, bytes] = {}
    at = 0
    while at < len(answer):
        end = answer.index(b"\n", at)
        words = answer[at:end].decode().split()
        at = end + 1
        if len(words) == 3:
            size = int(words[2])
            found[words[0]] = answer[at : at + size]
            at += size + 1
    return found


def _checkout(repository: str, sources: Path) -> Path | None:
    folder = sources / repository.replace("/", "+")
    for place in (folder / "repo", folder, sources / repository):
        if (place / ".git").exists() or (place / "HEAD").is_file():
            return place
    return None


def _git(*arguments: str, data: bytes = b"") -> bytes:
    done = subprocess.run(["git", *arguments], input=data, capture_output=True)
    if done.returncode:
        raise Missing(done.stderr.decode(errors="replace").strip())
    return done.stdout
