"""Named groups of pupils, on the teacher's page: {"t":"group","do"}, do is keep (`name`, `names`) or drop (`name`).

They are in a file of the server, so that every page of the teacher has them, and the next server. A group is its names, whether
those pupils are here or not.
"""

from __future__ import annotations

import asyncio
import json
from pathlib import Path
from typing import Any

from aiohttp import web

from day6_core.classroom.roster import MOST_PUPILS
from day6_core.reason import reason
from day6_core.whole_file import write_private
from day6_tui.locale import Texts
from day6_tui.web import names
from day6_tui.web.class_part import Answer, Hear, names_of
from day6_tui.web.names import BadName
from day6_tui.web.roster_feed import RosterFeed

MOST_GROUPS = 40
LARGEST = 1 << 20
"""Bytes of the file."""

_VERSION = 1


class ClassGroups:
    """Holds the groups: name -> the pupils' names."""

    def __init__(self, feed: RosterFeed, file: Path) -> None:
        self._feed = feed
        self._file = file
        self._writing = asyncio.Lock()
        self._groups: dict[str, list[str]] = {}
        self._is_unread = False
        """Whether the file could not be read, which the teacher is to know."""
        try:
            self._groups = read(file)
        except (OSError, ValueError):
            self._is_unread = True

    def hears(self) -> dict[str, Hear]:
        """What the teacher does with groups."""
        return {"group": self._change}

    def routes(self) -> list[web.RouteDef]:
        """It has none."""
        return []

    def state(self, texts: Texts) -> dict[str, Any]:
        """All groups, by name."""
        if self._is_unread:
            self._is_unread = False
            self._feed.say("serve.groups.unread", file=str(self._file))
        return {"groups": [{"name": name, "names": self._groups[name]} for name in sorted(self._groups)]}

    async def _change(self, found: dict[str, Any]) -> Answer:
        do, why = found["do"], ""
        if do == "keep":
            why = self._keep(str(found["name"]), names_of(found) or [])
        elif do == "drop":
            self._groups.pop(str(found["name"]), None)
        else:
            raise ValueError("there is no such thing to do with a group")
        if why:
            self._feed.say(why, most=MOST_GROUPS)
            return None
        self._feed.tell()
        await self._write()
        return None

    def _keep(self, text: str, chosen: list[str]) -> str:
        """Keep a group, also in place of an old one of this name; return the key of what is wrong."""
        try:
            name = names.clean(text)
        except BadName as error:
            return str(error)
        known = set(self._feed.roster.names())
        if not (members := [each for each in dict.fromkeys(chosen) if each in known]):
            return "serve.groups.nobody"
        if name not in self._groups and len(self._groups) >= MOST_GROUPS:
            return "serve.groups.many"
        self._groups[name] = members
        return ""

    async def _write(self) -> None:
        async with self._writing:  # or an older state might be written last
            text = json.dumps({"version": _VERSION, "groups": self._groups}, ensure_ascii=False, indent=1)
            try:
                await asyncio.to_thread(write_private, self._file, text.encode())
            except OSError as error:  # they are good until the server ends
                self._feed.say("serve.groups.unkept", file=str(self._file), reason=reason(error))


def read(file: Path) -> dict[str, list[str]]:
    """The groups of the file; none if there is no file. Raises ValueError if it is not ours, OSError."""
    try:
        with open(file, "rb") as opened:
            data = opened.read(LARGEST + 1)
    except FileNotFoundError:
        return {}
    try:
        if len(data) > LARGEST:
            raise ValueError
        groups = json.loads(data)["groups"].items()
        return {
            names.clean(name): [str(each) for each in list(members)[:MOST_PUPILS]]
            for name, members in list(groups)[:MOST_GROUPS]
        }
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        raise ValueError("not a file of groups") from None
