"""Completions for `colcon`: verbs, options, and the names of the workspace's packages."""

from __future__ import annotations

import argparse
import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.workspace.arguments import VERBS, build_parser
from day6_core.workspace.handlers import HANDLERS
from day6_core.workspace.packages import find_packages

if TYPE_CHECKING:
    from day6_core.session.session import Session

_NAMED = re.compile(r"--packages-(?!.*regex|above-depth).*|--packages-(start|end)")


def complete(words: list[str], session: Session, cwd: Path, environment: Mapping[str, str]) -> list[str] | None:
    """Return the possible last words of a line that begins `colcon …`; None where a file is expected."""
    typed = words[-1]
    if len(words) == 2 and not typed.startswith("-"):
        return sorted(VERBS)
    verb = next((word for word in words[1:-1] if word in VERBS), None)
    if typed.startswith("-"):
        return _options(session, verb)
    option = next((word for word in reversed(words[1:-1]) if word.startswith("--")), "")
    if option == "--event-handlers":
        return sorted(f"{name}{sign}" for name in HANDLERS for sign in "+-")
    if option == "--executor":
        return ["parallel", "sequential"]
    if _NAMED.fullmatch(option) or verb == "info":
        packages = find_packages(["."], cwd, environment, lambda logger, text, level="": None)
        return sorted({package.name for package in packages} - set(words[2:-1]))
    return None


def _options(session: Session, verb: str | None) -> list[str]:
    parser: argparse.ArgumentParser = build_parser(session)
    verbs = next(action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
    chosen = verbs.choices[verb] if verb is not None else parser
    return sorted(name for action in chosen._actions for name in action.option_strings if name.startswith("--"))
