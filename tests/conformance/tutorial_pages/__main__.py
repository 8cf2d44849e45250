"""Plays the official tutorials on machines of ours and writes the table page by page.

    python tests/conformance/tutorial_pages --documentation CLONE --branch jazzy [--mirror DIR] [--report DIR] [--write] [WORD…]

The machines have the distribution that a branch is about, as with `day6-tui --distro`.
Of Lyrical the table has the beginner's pages. No clone with its branch could be had: they were played from one of October 2024,
to which the commands and outputs were added that its pages of 2026 have besides, at the places where those are.

CLONE is a clone of the documentation; nothing of it is kept but the commands that do not run, or print something else. DIR of
`--mirror` has clones of the repositories that pages fetch from (`owner+name/repo`); without it such commands count as "network".
A WORD chooses pages by a part of their path; the pages before it in its home are played, too. `--report` keeps a file for each
page with every output and every difference. `--write` writes `tests/conformance/tutorials.json` anew for the pages played.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from day6_core.ros import distribution
from tests.conformance.tutorial_pages.documentation import Documentation
from tests.conformance.tutorial_pages.pages import Page, pages
from tests.conformance.tutorial_pages.table import TABLE, printed, summary


def play(documentation: Documentation, chain: list[Page], mirror: Path | None, report: Path | None) -> dict[str, Any]:
    """Play the pages of a chain in one home; return the rows of the table by page."""
    from tests import conftest as surroundings
    from tests.conformance.tutorial_pages.player import Player
    from tests.conformance.tutorial_pages.reader_machine import Machine

    done: dict[str, Any] = {}
    with tempfile.TemporaryDirectory(prefix="d6-", ignore_cleanup_errors=True) as folder:
        surroundings.set_environment(
            {
                **surroundings.environment(),
                distribution.HANDED_ON: documentation.branch,
                "DAY6_RUNTIME_DIR": f"{folder}/r",
                "DAY6_LINK": "on",
                "DAY6_HINTS": "off",
                "DAY6_WATCH": "0",
                "ROS_LOG_DIR": f"{folder}/log",
            }
        )
        for page in chain:
            machine = Machine(Path(folder, "home"))
            player = Player(documentation, page, machine, mirror)
            try:
                player.play()
            finally:
                machine.close()
            done[page.path] = summary(page, player)
            if report is not None:
                report.mkdir(parents=True, exist_ok=True)
                (report / f"{page.name}.txt").write_text(printed(page, player), encoding="utf-8")
            print(json.dumps({page.path: done[page.path]}), flush=True)
    return done


def main() -> int:
    """Play everything that was chosen; the exit status says whether a row lacks a reason."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--documentation", type=Path, required=True, help="clone of ros2_documentation")
    parser.add_argument("--branch", default="jazzy", choices=distribution.NAMES)
    parser.add_argument("--mirror", type=Path, help="folder with clones of repositories that pages fetch from")
    parser.add_argument("--report", type=Path, help="folder for every output and difference")
    parser.add_argument("--write", action="store_true", help="write the table of the project anew for these pages")
    parser.add_argument("--jobs", type=int, default=2, help="homes at a time")
    parser.add_argument("--chain", help=argparse.SUPPRESS)
    parser.add_argument("words", nargs="*", help="parts of the paths of pages (default: all)")
    chosen = parser.parse_args()
    distribution.choose(chosen.branch)
    documentation = Documentation(chosen.documentation, chosen.branch)
    every = pages(documentation.pages("source"))
    wanted = [page for page in every if not chosen.words or any(word in page.path for word in chosen.words)]
    chains = {page.chain: [each for each in every if each.chain == page.chain] for page in wanted}
    for name, chain in chains.items():
        last = max(at for at, page in enumerate(chain) if page in wanted)
        chains[name] = chain[: last + 1]
    if chosen.chain:
        play(documentation, chains[chosen.chain], chosen.mirror, chosen.report)
        sys.stdout.flush()
        os._exit(0)
    found: dict[str, Any] = {}
    with ThreadPoolExecutor(chosen.jobs) as pool:
        for rows in pool.map(_in_its_own_process, chains):
            for path, row in rows:
                if any(page.path == path for page in wanted):
                    found[path] = row
    return TABLE.take(chosen.branch, found, write=chosen.write)


def _in_its_own_process(chain: str) -> Iterable[tuple[str, Any]]:
    command = [sys.executable, "-m", "tests.conformance.tutorial_pages", "--chain", chain, *sys.argv[1:]]
    done = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert done.stdout is not None
    rows: list[tuple[str, Any]] = []
    for line in done.stdout:
        if line.startswith("{"):
            rows += json.loads(line).items()
            print(*(f"   {path}" for path in json.loads(line)), flush=True)
        else:
            print(line, end="", flush=True)
    if done.wait():
        print(f"-- {chain}: ended with status {done.returncode}", flush=True)
    return rows


if __name__ == "__main__":
    sys.exit(main())
