"""How two processes begin to talk: each says who it is, and over TCP proves that it can read this user's password.

Whoever connects speaks first. A proof is made of both sides' random numbers and the port, so that it is worth nothing to anybody
who repeats it or passes it on from another port; the password itself is never sent. A Unix socket needs none of this: it lies in
a folder that nobody else may enter.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator

from day6_core.link.local.frames import VERSION, Frame, Kind, Malformed, packed

_NONCE_BYTES = 16
_LONGEST_ZID = 32


class Handshake:
    """One side of it. `take` gives the frames to send; the connection may be used once `done`."""

    def __init__(
        self,
        zid: str,
        *,
        calling: bool,
        password: str = "",
        port: int = 0,
        is_welcome: Callable[[str], bool] = lambda zid: True,
    ) -> None:
        self._zid = zid
        self._is_welcome = is_welcome
        self.calling = calling
        """Whether this side connected."""
        self._password = password
        self._port = port
        self._nonce = os.urandom(_NONCE_BYTES)
        self._expected = b""
        self.zid = ""
        """The other session's id, once it has said it."""
        self.done = False

    def begin(self) -> bytes:
        """Return the first frame."""
        return packed(Kind.HELLO, VERSION, self._zid.encode(), self._nonce)

    def take(self, frame: Frame) -> Iterator[bytes]:
        """Take a frame of the other side; yield the answers.

        Raises:
            Malformed: the other side is not to be let in.
        """
        if frame.kind == Kind.HELLO and not self.zid:
            yield from self._greet(frame)
        elif frame.kind == Kind.PROOF and self._expected:
            self._check(frame.attachment)
        else:
            raise Malformed(f"kind {frame.kind} before it was let in")

    def _greet(self, frame: Frame) -> Iterator[bytes]:
        if frame.number != VERSION:
            raise Malformed(f"version {frame.number}")
        if not 0 < len(frame.key) <= _LONGEST_ZID or len(frame.attachment) != _NONCE_BYTES:
            raise Malformed("no session")
        if not self.calling and not self._is_welcome(frame.key):
            raise Malformed("not needed")
        self.zid = frame.key
        if not self.calling:
            yield self.begin()
        if not self._password:
            self.done = True
            return
        self._expected = self._proof(not self.calling, frame.attachment)
        yield packed(Kind.PROOF, 0, attachment=self._proof(self.calling, frame.attachment))

    def _proof(self, of_caller: bool, their_nonce: bytes) -> bytes:
        import hmac

        ours, theirs = (self._nonce, self._zid.encode()), (their_nonce, self.zid.encode())
        caller, called = (ours, theirs) if self.calling else (theirs, ours)
        told = b"/".join((b"caller" if of_caller else b"called", b"%d" % self._port, *caller, *called))
        return hmac.digest(self._password.encode(), told, "sha256")

    def _check(self, proof: bytes) -> None:
        import hmac

        if not hmac.compare_digest(proof, self._expected):
            raise Malformed("another password")
        self.done = True
