"""The folder on the stick: wheels, their sums, and how to install them. Only what an earlier run has written is replaced.

A run that is broken off, by a full disk or because the stick is pulled out, leaves a list of sums that has the new files beside
the old ones, so that the next run knows whose they are and goes on.
"""

from __future__ import annotations

import hashlib
import re
import shutil
import tempfile
from collections import defaultdict
from collections.abc import Iterator, Mapping, Set
from contextlib import contextmanager, suppress
from pathlib import Path

from day6_core.reason import reason
from day6_core.whole_file import replace_file

SUMS, GUIDE, CHECK, LIST = "SHA256SUMS", "INSTALL.txt", "check.py", "requirements.txt"
WHEEL, PART = ".whl", ".whl.part"


class NotOurs(Exception):
    """There is a file that no run of ours has written; the message is its name."""


def known(folder: Path) -> dict[str, set[str]]:
    """Return the sums that files written by earlier runs may have, by name. Raises OSError."""
    try:
        lines = (folder / SUMS).read_text(encoding="utf-8", errors="replace").splitlines()
    except FileNotFoundError:
        return {}
    found = defaultdict[str, set[str]](set)
    for digest, _, name in (line.partition("  ") for line in lines):
        if "/" not in name:
            found[name].add(digest)
    return dict(found)


def sum_of(path: Path) -> str:
    """Return the SHA-256 of a file as hexadecimal digits."""
    digest = hashlib.sha256()
    with path.open("rb") as file:
        for piece in iter(lambda: file.read(1 << 20), b""):
            digest.update(piece)
    return digest.hexdigest()


def foreign(folder: Path) -> str:
    """Return the name of a file in the folder that no earlier run has written, or a text that was changed since; '' if none."""
    if not folder.exists():
        return ""
    ours = known(folder)
    return next((path.name for path in sorted(folder.iterdir()) if not _is_ours(path, ours)), "")


def _is_ours(path: Path, ours: Mapping[str, Set[str]]) -> bool:
    if not path.is_file() or path.is_symlink():
        return False
    if path.name == SUMS or _is_part(path):
        return True
    # Nobody writes notes into a wheel: one with another sum is damaged, and is fetched again.
    return path.name in ours and (path.suffix == WHEEL or sum_of(path) in ours[path.name])


def _is_part(path: Path) -> bool:
    """Whether it is the beginning of a file: of a wheel, or as `replace_file` leaves it when it is killed."""
    return re.fullmatch(r"\.(.+\.whl\.part|day6-[0-9a-f]{12})", path.name) is not None


def try_to_write(folder: Path) -> None:
    """Raise OSError, which names the folder, if nothing can be written there; leaves nothing."""
    with _naming(folder):
        made = [each for each in (folder, *folder.parents) if not each.exists()]
        folder.mkdir(parents=True, exist_ok=True)
        try:
            with tempfile.TemporaryFile(dir=folder) as file:
                file.write(b"?")
        finally:
            with suppress(OSError):
                for each in made:
                    each.rmdir()


def fill(folder: Path, wheels: list[Path], texts: dict[str, str]) -> None:
    """Put wheels and texts into a folder that holds nothing foreign, and the sums of all.

    Raises NotOurs, and OSError, which names the folder.
    """
    if name := foreign(folder):
        raise NotOurs(name)
    with _naming(folder):
        folder.mkdir(parents=True, exist_ok=True)
        for path in filter(_is_part, list(folder.iterdir())):
            path.unlink()
        old = known(folder)
        new = {wheel.name: sum_of(wheel) for wheel in wheels}
        new |= {name: hashlib.sha256(text.encode()).hexdigest() for name, text in texts.items()}
        _write_sums(
            folder, {name: old.get(name, set()) | {new[name]} if name in new else old[name] for name in old | new}
        )
        for wheel in wheels:
            _copy(wheel, folder / wheel.name, new[wheel.name])
        for name, text in texts.items():
            replace_file(folder / name, text.encode())
        for name in old.keys() - new.keys():
            (folder / name).unlink(missing_ok=True)
        _write_sums(folder, {name: {digest} for name, digest in new.items()})


def _copy(wheel: Path, target: Path, digest: str) -> None:
    """Copy a wheel, unless it is there and whole."""
    if target.is_file() and sum_of(target) == digest:
        return
    part = target.with_name(f".{target.name.removesuffix(WHEEL)}{PART}")
    try:
        shutil.copyfile(wheel, part)
        part.replace(target)
    except OSError:
        with suppress(OSError):
            part.unlink(missing_ok=True)
        raise


def _write_sums(folder: Path, sums: Mapping[str, Set[str]]) -> None:
    lines = "".join(f"{digest}  {name}\n" for name in sorted(sums) for digest in sorted(sums[name]))
    replace_file(folder / SUMS, lines.encode())


@contextmanager
def _naming(folder: Path) -> Iterator[None]:
    """Make an OSError inside the block name the folder, the only place that its user knows of."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, reason(error), str(folder)) from error
