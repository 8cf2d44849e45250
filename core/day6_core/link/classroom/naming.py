"""The namings of a class (see `day6_core/link/naming.py`): a pupil's bridge wraps its keys, the teacher's also renames them.

anna's graph                      on the wire                                       the teacher's graph
7/chatter/…                       day6_class/up/anna/0/chatter/…                    0/anna/chatter/…
@ros2_lv/7/…/NN/%/%/talker        day6_class/up/anna/@ros2_lv/0/…/NN/%/%/talker     @ros2_lv/0/…/NN/%/%anna/talker
7/turtle1/cmd_vel/…               day6_class/down/anna/0/turtle1/cmd_vel/…          0/anna/turtle1/cmd_vel/…
"""

from __future__ import annotations

from day6_core.link.classroom.keys import DOWN, TEACHER, UP, WIRE_DOMAIN, is_name
from day6_core.link.keys import LIVELINESS_PREFIX

_NAMESPACE, _TOPIC = 7, 9
"""Places of chunks in the token of a node or an endpoint."""


class PupilNaming:
    """Of the pupil `name`, whose own graph has this domain."""

    renames = True

    def __init__(self, name: str, domain_id: int) -> None:
        self._up, self._down = f"{UP}/{name}/", f"{DOWN}/{name}/"
        self._domain = str(domain_id)

    def sent(self, inner: str) -> str | None:
        return self._up + _in_domain(inner, WIRE_DOMAIN)

    def answered(self, outer: str) -> str | None:
        return self._without(self._up, outer)

    def awaited(self, inner: str) -> str | None:
        return self._down + _in_domain(inner, WIRE_DOMAIN)

    def heard(self, outer: str) -> str | None:
        return self._without(self._down, outer)

    def _without(self, prefix: str, outer: str) -> str | None:
        return _in_domain(outer[len(prefix) :], self._domain) if outer.startswith(prefix) else None

    def tokens(self) -> tuple[str, ...]:
        return f"{self._down}{LIVELINESS_PREFIX}/{WIRE_DOMAIN}/**", self.caches()

    def caches(self) -> str:
        return f"{self._down}{WIRE_DOMAIN}/**/@adv/**"


class TeacherNaming:
    """Of the teacher, who has each pupil's graph below the pupil's name."""

    renames = True

    def __init__(self, domain_id: int) -> None:
        self._domain = str(domain_id)

    def sent(self, inner: str) -> str | None:
        return _to_pupil(inner, DOWN)

    def answered(self, outer: str) -> str | None:
        return self._from_pupil(outer, DOWN)

    def awaited(self, inner: str) -> str | None:
        return _to_pupil(inner, UP)

    def heard(self, outer: str) -> str | None:
        return self._from_pupil(outer, UP)

    def _from_pupil(self, outer: str, way: str) -> str | None:
        name, slash, key = outer.removeprefix(f"{way}/").partition("/")
        if not (slash and outer.startswith(f"{way}/") and is_name(name)):
            return None
        parts = key.split("/")
        if parts[0] != LIVELINESS_PREFIX:
            return "/".join([self._domain, name, *parts[1:]]) if parts[0] == WIRE_DOMAIN else None
        if len(parts) <= _NAMESPACE:
            return None
        parts[1] = self._domain
        for place in (_NAMESPACE, _TOPIC):
            if place < len(parts):
                parts[place] = f"%{name}{parts[place] if parts[place] != '%' else ''}"
        return "/".join(parts)

    def tokens(self) -> tuple[str, ...]:
        return f"{UP}/*/{LIVELINESS_PREFIX}/{WIRE_DOMAIN}/**", self.caches()

    def caches(self) -> str:
        return f"{UP}/*/{WIRE_DOMAIN}/**/@adv/**"


def _to_pupil(inner: str, way: str) -> str | None:
    """Return the key for the pupil an inner key names; None for what concerns no pupil, as the teacher's own nodes."""
    parts = inner.split("/")
    if parts[0] != LIVELINESS_PREFIX:
        _, name, *rest = *parts, ""
        return "/".join([way, name, WIRE_DOMAIN, *rest[:-1]]) if len(parts) > 2 and is_name(name) else None
    if len(parts) <= _TOPIC:
        return None
    _, name, topic = (*parts[_TOPIC].split("%", 2), "", "")[:3]
    if not (topic and is_name(name)):
        return None
    parts[1], parts[_TOPIC] = WIRE_DOMAIN, f"%{topic}"
    parts[_NAMESPACE] = f"%{TEACHER}{parts[_NAMESPACE] if parts[_NAMESPACE] != '%' else ''}"
    return "/".join([way, name, *parts])


def _in_domain(key: str, domain: str) -> str:
    """Return a key of a graph with another domain in it."""
    parts = key.split("/", 2)
    parts[1 if parts[0] == LIVELINESS_PREFIX else 0] = domain
    return "/".join(parts)
