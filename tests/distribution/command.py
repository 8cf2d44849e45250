"""The real command, and a script of the simulated terminal whose parts are told apart."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


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
