"""The table of the tutorials: a row for each page, and with it each command that did not do as shown, with the reason."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tests.conformance.tutorial_pages.judge import Verdict, masked
from tests.conformance.tutorial_pages.reasons import reason

if TYPE_CHECKING:
    from tests.conformance.tutorial_pages.pages import Page
    from tests.conformance.tutorial_pages.player import Player, Row

FILE = Path(__file__).resolve().parents[1] / "tutorials.json"


def summary(page: Page, player: Player) -> dict[str, Any]:
    """Return the row of a page: counts, and the rest by command with verdict and reason."""
    rows = [row for row in player.rows if row.verdict != "form"]
    shown = [row for row in rows if row.kind]
    rest = [
        {"command": row.command, "is": _is(row), "difference": digest(row), "reason": reason(page.name, row)}
        for row in rows
        if row.verdict not in ("run", "window") or row.kind in (Verdict.DIFFERS, Verdict.MORE)
    ]
    return {
        "commands": len(rows),
        "forms": len(player.rows) - len(rows),
        "files": len(set(player.files)),
        "run": sum(row.verdict in ("run", "window") for row in rows),
        "windows": sum(row.verdict == "window" for row in rows),
        "shown": len(shown),
        "equal": sum(row.kind in (Verdict.EQUAL, Verdict.ORDER) for row in shown),
        "rest": rest,
    }


def digest(row: Row) -> str:
    """Return a mark of what differs, by which a row whose reason is an old one is noticed; '' for what was not compared.

    How often a program says a line again is chance.
    """
    lines = sorted({line for line in row.difference if line.startswith(("+", "-")) and line[:3] not in ("+++", "---")})
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:12] if lines else ""


def _is(row: Row) -> str:
    return row.verdict if row.verdict not in ("run", "window") else f"output {row.kind}"


def printed(page: Page, player: Player) -> str:
    """Return everything that happened at a page, for a reader who looks into it."""
    lines = [f"{page.path}", "files: " + ", ".join(player.files), ""]
    for row in player.rows:
        lines.append(f"=== {row.line}: {row.command}")
        status = None if row.run is None else row.run.status
        lines.append(f"--- {row.verdict} (status {status}) {row.kind} {reason(page.name, row)}")
        lines += [f"    {line}" for line in masked(row.output)[:60]]
        if row.kind in (Verdict.DIFFERS, Verdict.MORE):
            lines += [f"  ! {line}" for line in row.difference]
    return "\n".join(lines) + "\n"


class Table:
    """The table in the project, by branch and page."""

    def __init__(self, file: Path) -> None:
        self._file = file

    def read(self) -> dict[str, dict[str, Any]]:
        return json.loads(self._file.read_text(encoding="utf-8")) if self._file.is_file() else {}

    def take(self, branch: str, found: Mapping[str, Any], *, write: bool) -> int:
        """Print rows, and put them into the file if they are to be kept.

        Return 1 if one has no reason, or differs otherwise than when it was last kept: then its reason has to be looked at.
        """
        names = ("commands", "files", "run", "windows", "shown", "equal")
        print(f"{'page':72}" + "".join(f"{name:>9}" for name in names))
        total = dict.fromkeys(names, 0)
        without = changed = 0
        kept = self.read()
        for path, row in found.items():
            print(
                f"{path.removeprefix('source/').removeprefix('Tutorials/').removesuffix('.rst')[-71:]:72}"
                + "".join(f"{row[name]:9}" for name in names)
            )
            for name in names:
                total[name] += row[name]
            known = [_seen(each) for each in kept.get(branch, {}).get(path, {"rest": ()})["rest"]]
            for each in row["rest"]:
                without += not each["reason"]
                new = _seen(each) not in known
                changed += new
                print(
                    f"  {'*' if new else ' '} {each['is']:24}{each['reason'] or 'NO REASON':20}  {each['command'][:100]!r}"
                )
        print(f"{f'{len(found)} pages of {branch}':72}" + "".join(f"{total[name]:9}" for name in names))
        print(
            f"{without} rows without a reason; {changed} rows (*) are new or differ otherwise than before: is the reason true?"
        )
        if write:
            kept[branch] = {**kept.get(branch, {}), **found}
            self._file.write_text(
                json.dumps(kept, indent=1, ensure_ascii=False, sort_keys=False) + "\n", encoding="utf-8"
            )
        return int(without > 0 or changed > 0)


def _seen(row: Mapping[str, str]) -> tuple[str, ...]:
    return row["command"], row["is"], row.get("difference", "")


TABLE = Table(FILE)
