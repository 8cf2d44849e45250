"""Bags: reading, writing, recording and playing, with the names of the real rosbag2_py.

`_mcap_*` and `_sqlite*` are the storages; `ros2 bag` and `Recorder`/`Player` run `_recording` and `_playing`; `_blocks` is an
index of what is in a file. Everything is imported on first use. It builds on rclpy and `day6_core.interfaces`; `ros2 bag` and
rqt_bag import its private modules too.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_PLACES = {
    "_compression": "CompressionMode CompressionOptions compression_mode_from_string compression_mode_to_string "
    "get_registered_compressors",
    "_definitions": "LocalMessageDefinitionSource",
    "_files": "get_registered_readers get_registered_serializers get_registered_writers",
    "_info": "Info",
    "_metadata": "MetadataIo",
    "_qos": "QoS convert_rclcpp_qos_to_rclpy_qos to_rclcpp_qos_vector",
    "_reader": "SequentialCompressionReader SequentialReader",
    "_reindexer": "Reindexer",
    "_rewrite": "bag_rewrite",
    "_storage": "BagMetadata ConverterOptions FileInformation MessageDefinition ReadOrder ReadOrderSortBy StorageFilter "
    "StorageOptions TopicInformation TopicMetadata get_default_storage_id",
    "_transport": "PlayOptions Player RecordOptions Recorder ServiceRequestsSource",
    "_writer": "SequentialCompressionWriter SequentialWriter",
}
_REAL_PLACES = {
    "_compression_options": "CompressionMode CompressionOptions compression_mode_from_string compression_mode_to_string",
    "_message_definitions": "LocalMessageDefinitionSource",
    "_storage": "MetadataIo QoS convert_rclcpp_qos_to_rclpy_qos rmw_qos_durability_policy_t rmw_qos_history_policy_t "
    "rmw_qos_liveliness_policy_t rmw_qos_reliability_policy_t to_rclcpp_qos_vector",
    "_transport": "bag_rewrite",
}
"""Modules of the real one, which programs name too (rosbag2_py._storage.TopicMetadata), and what else is in them here."""

_MODULE_OF = {name: module for module, names in _PLACES.items() for name in names.split()}

__all__ = sorted(_MODULE_OF)


def also(module: str) -> Callable[[str], Any]:
    """Return the `__getattr__` of a module that has names of others, as in `_REAL_PLACES`."""

    def find(name: str) -> Any:
        if name not in _REAL_PLACES[module].split():
            raise AttributeError(f"module '{__name__}.{module}' has no attribute '{name}'")
        if name.startswith("rmw_qos_") or name == "QoS":
            from rosbag2_py import _qos

            return getattr(_qos, name)
        return __getattr__(name)

    return find


def __getattr__(name: str) -> Any:
    if name not in _MODULE_OF and name not in _PLACES and name not in _REAL_PLACES:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    from importlib import import_module

    if name not in _MODULE_OF:
        return import_module(f"{__name__}.{name}")
    value = getattr(import_module(f"{__name__}.{_MODULE_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
