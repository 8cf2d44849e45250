"""Chance that is the same in every run: `os.urandom`, and what `random` and NumPy begin with.

The module secrets stays as it is: what it makes has to be unlike anything else on the machine.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import os
from collections.abc import Callable
from typing import Any

from day6_core.virtual.follow.builtin import put
from day6_core.virtual.follow.imports import when_imported

_real_urandom = os.urandom
_stream: Any = None
"""Where all of it comes from, once something is asked for."""
_random_module: Any = None
"""Once it is imported."""


def install(number: Callable[[], int]) -> None:
    """Have what begins from the system's random numbers begin from the process's number in its world."""

    def bits(k: int) -> int:
        global _stream
        if _stream is None:
            import _random

            _stream = _random.Random(number() + 1)
        found: int = _stream.getrandbits(k)
        return found

    def urandom(size: int, /) -> bytes:
        return (
            bits(8 * size).to_bytes(size, sys.byteorder) if isinstance(size, int) and size > 0 else _real_urandom(size)
        )

    put(os, urandom=urandom)
    when_imported("random", lambda module: _follow_random(module, bits))
    when_imported("secrets", lambda module: setattr(module, "randbits", bits))  # NumPy's seed


def begin_again() -> None:
    """Begin as a new process."""
    global _stream
    _stream = None
    if _random_module is not None:
        _random_module.seed()


def _follow_random(module: Any, bits: Callable[[int], int]) -> None:
    global _random_module
    _random_module = module
    module._urandom = _real_urandom  # of SystemRandom
    original = module.Random.seed

    def seed(self: Any, a: Any = None, version: int = 2) -> None:
        original(self, bits(64) if a is None else a, version)

    module.Random.seed = seed
    module.seed = module._inst.seed
    module.seed()
