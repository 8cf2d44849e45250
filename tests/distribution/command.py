"""The real command, and a script of the simulated terminal whose parts are told apart."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def day6(*words: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """Run `day6-tui WORDS…` with these variables besides those of the test."""
    return subprocess.run(
        [sys.executable, "-m", "day6_tui.tui.main", *words],
        env={**os.environ, **variables},
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=120,
    )


def sections(home: Path, parts: dict[str, str], **variables: str) -> dict[str, str]:
    """Run the parts of a script one after the other in one terminal; return what each of them printed, on either stream."""
    lines = "\n".join(f"echo '=={name}=='\n{{ {text.strip()}\n}} 2>&1" for name, text in parts.items())
    done = day6("exec", "--home", str(home), "-c", lines, **variables)
    found = re.split(r"^==(.+)==\n", done.stdout, flags=re.MULTILINE)
    assert found[1::2] == list(parts), done.stdout + done.stderr
    return dict(zip(found[1::2], found[2::2], strict=True))


@contextmanager
def started(*words: str, **variables: str) -> Iterator[None]:
    """Have `day6-tui WORDS…` run meanwhile."""
    command = [sys.executable, "-m", "day6_tui.tui.main", *words]
    with subprocess.Popen(
        command, env={**os.environ, **variables}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as process:
        try:
            yield
        finally:
            process.terminate()


def wait_for(text: str, *words: str, **variables: str) -> None:
    """Run `day6-tui WORDS…` until it prints the text; fails after a minute."""
    deadline = time.monotonic() + 60
    while text not in (said := day6(*words, **variables).stdout):
        assert time.monotonic() < deadline, said
