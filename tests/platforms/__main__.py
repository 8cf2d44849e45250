"""Tries every feature with the day6-tui that is installed for this Python, and prints what came of it.

    python -m tests.platforms [FEATURE …]
    python -m tests.platforms --record      also writes it into runs.json; then python -m tests.docs.reference writes the table

Needs pyte beside day6-tui, and for `serve` aiohttp and segno. Nothing of the user's own files is touched.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from tests.platforms import rows
from tests.platforms.features import FEATURES
from tests.platforms.play import YES, play
from tests.support.short_folder import remove_short_folders


def main() -> int:
    """Return 1 if something failed."""
    parser = argparse.ArgumentParser(prog="python -m tests.platforms", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("features", nargs="*", metavar="FEATURE", help=", ".join(each.key for each in FEATURES))
    parser.add_argument("--record", action="store_true", help=f"write what came of it into {rows.RUNS.name}")
    chosen = parser.parse_args()
    if unknown := set(chosen.features) - {each.key for each in FEATURES}:
        parser.error(f"there is no {', '.join(sorted(unknown))}")
    sys.stdout.reconfigure(encoding="utf-8", line_buffering=True)  # type: ignore[union-attr]  # Windows' own cannot write all
    cells = {}
    row = rows.here(cells)
    print(f"{row.date}, commit {row.commit or '?'}: {row.system} ({row.release}), Python {row.python}")
    print(f"without: {row.lacks or 'nothing'}\n")
    for feature in FEATURES:
        if feature.key in (chosen.features or feature.key):
            with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
                cells[feature.key] = play(feature, Path(folder))
            print(f"{feature.key:<12}{cells[feature.key]}")
    remove_short_folders()
    if chosen.record:
        rows.record(row)
    wrong = [key for key, said in cells.items() if said.startswith("fails")]
    print(f"\n{list(cells.values()).count(YES)} of {len(cells)} are there; fails: {', '.join(wrong) or 'nothing'}")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
