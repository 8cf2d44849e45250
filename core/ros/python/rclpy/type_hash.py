"""The hash of an interface's definition (REP 2016)."""

from __future__ import annotations


class TypeHash:
    """Version and 32 bytes; prints as `RIHS01_…` in hexadecimal, `INVALID` for version -1."""

    _TYPE_HASH_SIZE = 32
    __slots__ = ["_value", "_version"]

    def __init__(self, version: int = -1, value: bytes = bytes(32)) -> None:
        self.version = version
        self.value = value

    @classmethod
    def _parse(cls, text: str) -> TypeHash:
        """Return the hash that `RIHS01_…` stands for; an invalid one for anything else."""
        if not text.startswith("RIHS") or len(text) != len("RIHS01_") + 64:
            return cls()
        return cls(int(text[4:6]), bytes.fromhex(text[7:]))

    @property
    def version(self) -> int:
        """Version of the hashing rules."""
        return self._version

    @version.setter
    def version(self, value: int) -> None:
        assert isinstance(value, int)
        self._version = value

    @property
    def value(self) -> bytes:
        """The 32 bytes."""
        return self._value

    @value.setter
    def value(self, value: bytes) -> None:
        assert isinstance(value, bytes)
        self._value = value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TypeHash) and (self.version, self.value) == (other.version, other.value)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        if self._version <= 0 or len(self._value) != self._TYPE_HASH_SIZE:
            return "INVALID"
        return f"RIHS{self._version:02d}_{self._value.hex()}"
