"""Disks on which nothing can be written, for root as for everybody: full, read-only, gone.

Root may write everywhere, so what is tried on a read-only folder runs without that right (util-linux' setpriv). Full is a
`tmpfs` of a few kilobytes where one may be mounted, else a limit on the size of files, which says "File too large".
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

KINDS = ["full", "read-only", "gone"]
REASONS = {
    "full": ("No space left on device", "File too large"),
    "read-only": ("Permission denied",),
    "gone": ("No such file or directory",),
}
MAIN = [sys.executable, "-m", "day6_tui.main"]
ROOT = sys.platform != "win32" and os.geteuid() == 0
SETPRIV = shutil.which("setpriv")
WITHOUT_RIGHTS = ["--bounding-set", "-dac_override,-dac_read_search,-fowner,-chown", "--inh-caps", "-all"]


class Disk:
    """A folder that is as `kind` says when a command runs in it."""

    def __init__(self, kind: str, folder: Path) -> None:
        self.kind = kind
        self.folder = folder
        self._mounted = False

    def spoil(self) -> None:
        """From now on nothing can be written in the folder."""
        if self.kind == "read-only":
            if ROOT and SETPRIV is None:
                pytest.skip("for root no folder is read-only, and setpriv is not there")
            for path in [self.folder, *self.folder.rglob("*")]:
                path.chmod(path.stat().st_mode & ~0o222)
        elif self.kind == "full" and self._mounted:
            with (self.folder / "filler").open("wb", buffering=0) as filler:
                try:
                    while filler.write(b"\0" * 4096):
                        pass
                except OSError:
                    pass

    def mount(self) -> None:
        """Make the folder a small file system of its own, if this user may."""
        if self.kind == "full" and ROOT and sys.platform == "linux":
            words = ["mount", "-t", "tmpfs", "-o", "size=256k", "none", str(self.folder)]
            self._mounted = subprocess.run(words, capture_output=True, check=False).returncode == 0

    def unmount(self) -> None:
        if self._mounted:
            subprocess.run(["umount", "-l", str(self.folder)], check=False)
        for path in [self.folder, *self.folder.rglob("*")] if self.folder.exists() else []:
            path.chmod(path.stat().st_mode | 0o700)

    def prefix(self) -> list[str]:
        """What the command is run by."""
        if self.kind == "read-only" and ROOT:
            assert SETPRIV is not None
            return [SETPRIV, *WITHOUT_RIGHTS]
        if self.kind == "full" and not self._mounted:
            return ["bash", "-c", 'ulimit -f 0; exec "$@"', "bash"]
        if self.kind == "gone":
            return ["bash", "-c", 'rmdir "$PWD"; exec "$@"', "bash"]
        return []

    def run(self, *words: str, **variables: str) -> subprocess.CompletedProcess[str]:
        """Run a command of day6-tui in the folder; what it writes comes through pipes, which are never full."""
        return subprocess.run(
            [*self.prefix(), *MAIN, *words],
            cwd=self.folder,
            env={**os.environ, "DAY6_LINK": "off", "PYTHONDONTWRITEBYTECODE": "1", **variables},
            capture_output=True,
            text=True,
            timeout=120,
            stdin=subprocess.DEVNULL,
            check=False,
        )

    def is_told(self, text: str) -> bool:
        """Whether `text` says why nothing was written, without a word of Python but the last line of a real tool's traceback."""
        python = "Traceback" in text or re.search(r"(?<!Error: )\[Errno", text) is not None
        return not python and any(reason in text for reason in REASONS[self.kind])


@pytest.fixture(params=KINDS)
def disk(request: pytest.FixtureRequest) -> Iterator[Disk]:
    """Each kind of disk that takes nothing."""
    if sys.platform == "win32":
        pytest.skip("Windows has other disks")
    with tempfile.TemporaryDirectory(prefix="day6-disk-") as base:
        folder = Path(base, "here")
        folder.mkdir()
        made = Disk(str(request.param), folder)
        made.mount()
        try:
            yield made
        finally:
            made.unmount()
