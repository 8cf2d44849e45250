"""The real command, and a script of the simulated terminal whose parts are told apart."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.support.waiting import PATIENCE, run, until


def day6(*words: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """Run `day6-tui WORDS…` with these variables besides those of the test."""
    return run([sys.executable, "-m", "day6_tui.main", *words], limit=4 * PATIENCE, env={**os.environ, **variables})


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
    command = [sys.executable, "-m", "day6_tui.main", *words]
    with subprocess.Popen(
        command, env={**os.environ, **variables}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as process:
        try:
            yield
        finally:
            process.terminate()


def wait_for(text: str, *words: str, **variables: str) -> None:
    """Run `day6-tui WORDS…` until it prints the text."""
    said = ""

    def printed() -> bool:
        nonlocal said
        said = day6(*words, **variables).stdout
        return text in said

    until(printed, 2 * PATIENCE, told=lambda: said)
