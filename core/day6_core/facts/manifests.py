"""Manifests (package.xml) that colcon does not take for a package's: it leaves such a folder out, most often without a word."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

from day6_core.facts.folders import text_of
from day6_core.plain_xml import plain_xml

_NEEDED = ("name", "version", "description", "maintainer", "license")
"""What catkin_pkg, and so colcon, wants of every package."""
_PLACE = re.compile(r"^(.*): line (\d+), column \d+$")


class Refused(NamedTuple):
    """Why: 'xml' (no XML; `what` is the parser's reason), 'root' (`what` is the outermost tag) or 'lacks' (`what` is missing)."""

    because: str
    what: str
    line: int = 0


def refused(manifest: Path) -> Refused | None:
    """Return why a manifest is none, None if it is one as far as can be told."""
    try:
        root = plain_xml(text_of(manifest))
    except ValueError as error:
        place = _PLACE.match(str(error))
        return Refused("xml", place[1], int(place[2])) if place is not None else Refused("xml", str(error))
    if root.tag != "package":
        return Refused("root", root.tag)
    lacks = [tag for tag in _NEEDED if not (root.findtext(tag) or "").strip()]
    return Refused("lacks", lacks[0]) if lacks else None
