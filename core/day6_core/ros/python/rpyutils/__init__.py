"""Finding libraries: the part of rpyutils that rclpy's own tests and a few programs import."""

from __future__ import annotations

from rpyutils.add_dll_directories import add_dll_directories_from_env as add_dll_directories_from_env
from rpyutils.import_c_library import import_c_library as import_c_library
