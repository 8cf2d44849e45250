"""`ros2 bag list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Print information about available plugins to the screen"


class _Plugin(NamedTuple):
    name: str
    description: str
    type: str
    base_class: str


_STORAGE = "rosbag2_storage::storage_interfaces::ReadWriteInterface"
_PLUGINS: dict[str, tuple[_Plugin, ...]] = {
    "storage": (
        _Plugin("mcap", "MCAP files, with an index and the message definitions", "rosbag2_py.McapWriter", _STORAGE),
        _Plugin("sqlite3", "SQLite databases", "rosbag2_py.SqliteWriter", _STORAGE),
    ),
    "converter": (),
    "compressor": (
        _Plugin(
            "zstd",
            "Zstandard, when Python has a library for it",
            "rosbag2_py.zstd_compress",
            "rosbag2_compression::BaseCompressorInterface",
        ),
    ),
    "decompressor": (
        _Plugin(
            "zstd",
            "Zstandard, when Python has a library for it",
            "rosbag2_py.decompress",
            "rosbag2_compression::BaseDecompressorInterface",
        ),
    ),
}


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("plugin_type", help="lists available plugins", choices=tuple(_PLUGINS))
    parser.add_argument(
        "-v", "--verbose", action="store_true", help="output verbose information about the available plugin"
    )


async def main(session: Session, args: Namespace) -> None:
    if args.verbose:
        session.print(f"available {args.plugin_type} plugins are:")
    for plugin in _PLUGINS[args.plugin_type]:
        session.print(f"name: {plugin.name}" if args.verbose else plugin.name)
        if args.verbose:
            session.print(f"\t{plugin.description}\n\ttype: {plugin.type}\n\tbase_class: {plugin.base_class}")
