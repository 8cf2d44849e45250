"""How a bridge writes a key on its outer side: as it is, or wrapped and renamed as in a class (`classroom/naming.py`).

An inner key is one of this machine's graph, an outer one what other machines see. A bridge sends (messages, requests,
tokens) and receives; what is sent and what is received may have different keys outside.
"""

from __future__ import annotations

from typing import Protocol


class Naming(Protocol):
    """The four translations, and where the outer side is listened to."""

    renames: bool
    """Whether any key differs; then so do the GIDs, which are hashes of tokens."""

    def sent(self, inner: str, /) -> str | None:
        """Return the outer key of something that is sent out; None if it stays here."""

    def answered(self, outer: str, /) -> str | None:
        """Return the inner key of what comes back to something that was `sent`; None if it does not belong here."""

    def awaited(self, inner: str, /) -> str | None:
        """Return the outer key where something for an inner key is received."""

    def heard(self, outer: str, /) -> str | None:
        """Return the inner key of something that was received; None if it does not belong here."""

    def tokens(self) -> tuple[str, ...]:
        """Return the outer key expressions of the liveliness tokens that are followed."""

    def caches(self) -> str:
        """Return the outer key expression of the caches of transient-local publishers.

        Wildcards do not match a chunk that begins with @, so the expressions for messages do not cover it.
        """


class Plain:
    """Every key as it is: any machine with rmw_zenoh's keys is one more peer."""

    renames = False

    def __init__(self, domain_id: int) -> None:
        self._domain_id = domain_id

    def sent(self, inner: str, /) -> str | None:
        return inner

    answered = awaited = heard = sent

    def tokens(self) -> tuple[str, ...]:
        return f"@ros2_lv/{self._domain_id}/**", self.caches()

    def caches(self) -> str:
        return f"{self._domain_id}/**/@adv/**"
