"""Compression of whole bag files or of each message, by Zstandard. MCAP's chunks are compressed by the mcap library."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from day6_core.parts import MissingPart, part


class CompressionMode(IntEnum):
    """The unit of compression: none, each finished file, each message."""

    NONE = 0
    FILE = 1
    MESSAGE = 2


@dataclass
class CompressionOptions:
    """How a bag is compressed; the real one's threads and queues are accepted and ignored."""

    compression_format: str = ""
    compression_mode: CompressionMode = CompressionMode.NONE
    compression_queue_size: int = 1
    compression_threads: int = 0
    compression_threads_priority: int = 0


def compression_mode_from_string(text: str) -> CompressionMode:
    """Return the mode called 'NONE', 'FILE' or 'MESSAGE'; 'NONE' for anything else."""
    return CompressionMode.__members__.get(text.upper(), CompressionMode.NONE)


def compression_mode_to_string(mode: CompressionMode) -> str:
    """Return the name of a mode."""
    return CompressionMode(mode).name


def get_registered_compressors() -> set[str]:
    """Return the formats of `--compression-format`."""
    return {"zstd"}


class MissingCodec(RuntimeError):
    """The package that a compression needs isn't installed."""


def codec(name: str) -> Any:
    """Return the package of a compression, 'zstd' or 'lz4'; None for any other. Raises MissingCodec."""
    package = {"zstd": "zstandard", "lz4": "lz4"}.get(name)
    try:
        return part(package, "compressed bags need") if package else None
    except MissingPart as error:
        raise MissingCodec(str(error)) from None


def zstd_compress(data: bytes, level: int) -> bytes:
    """Compress data as one Zstandard frame. Raises MissingCodec."""
    compressed: bytes = codec("zstd").ZstdCompressor(level=level).compress(data)
    return compressed


def decompress(name: str, data: bytes) -> bytes:
    """Decompress data; `name` is the format ('': not compressed).

    Raises:
        RuntimeError: the name is unknown, the data are damaged, or what unpacks them isn't installed.
    """
    if not name:
        return data
    if name == "zstd":
        zstandard = codec(name)
        try:
            plain: bytes = zstandard.ZstdDecompressor().decompressobj().decompress(data)
            return plain
        except zstandard.ZstdError as error:
            raise RuntimeError(f"zstd: {error}") from None
    raise RuntimeError(f"unsupported compression: {name}")
