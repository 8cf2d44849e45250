"""The names of the packages that are released for ROS 2, of which day6-tui has a few: those that a pupil didn't make up.

`released_packages.txt` has those of humble, jazzy, kilted, lyrical and rolling in ros/rosdistro (`distribution.yaml`, August
2026), one a line. Beside them are the libraries of the system for which packages of ROS look.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

_SYSTEM = frozenset({
    "assimp", "boost", "bullet", "ceres", "cuda", "curl", "eigen3", "ffmpeg", "fmt", "gazebo", "gflags", "glew", "glib",
    "glog", "gtest", "gtsam", "libusb", "nlohmann_json", "opencv", "opengl", "openmp", "openssl", "pcl", "protobuf",
    "qt5", "qt6", "sdl2", "spdlog", "sqlite3", "tbb", "tinyxml2", "vtk", "yaml-cpp", "zlib",
})  # fmt: skip


@cache
def released_packages() -> frozenset[str]:
    """Return the names of the packages of ROS 2."""
    return frozenset(Path(__file__).with_name("released_packages.txt").read_text(encoding="utf-8").split())


def is_released(name: str) -> bool:
    """Return whether a package of ROS 2, or a library of the system that such packages use, has this name."""
    return name in released_packages() or name.lower() in _SYSTEM or name.startswith(("gz-", "ignition-"))
