"""The kinds of machines a wheelhouse can be for: what pip calls them, and what markers see there."""

from __future__ import annotations

import platform
import sys
from dataclasses import dataclass

PYTHONS = ("3.10", "3.11", "3.12", "3.13", "3.14")
"""The versions of Python that day6-tui is for."""


@dataclass(frozen=True)
class Platform:
    """A system on a kind of processor. `tags` are pip's names for it, for wheels that run on any that is not too old."""

    name: str
    tags: tuple[str, ...]
    sys_platform: str
    system: str
    os_name: str
    machine: str


def _linux(machine: str) -> Platform:
    # Debian 12, Ubuntu 22.04 and Raspberry Pi OS of that time have glibc 2.35 or later.
    tags = (f"manylinux2014_{machine}", *(f"manylinux_2_{minor}_{machine}" for minor in range(17, 36)))
    return Platform(f"linux-{machine}", tags, "linux", "Linux", "posix", machine)


def _macos(machine: str, first: tuple[int, int]) -> Platform:
    tags = (f"macosx_{first[0]}_{first[1]}_{machine}", *(f"macosx_{major}_0_{machine}" for major in range(11, 15)))
    return Platform(f"macos-{machine}", tuple(dict.fromkeys(tags)), "darwin", "Darwin", "posix", machine)


PLATFORMS = {
    each.name: each
    for each in (
        _linux("x86_64"),
        _linux("aarch64"),
        Platform("windows-x86_64", ("win_amd64",), "win32", "Windows", "nt", "AMD64"),
        _macos("arm64", (11, 0)),
        _macos("x86_64", (10, 9)),
    )
}
"""linux-aarch64 is also Raspberry Pi OS with 64 bits."""


@dataclass(frozen=True)
class Target:
    """A platform with a version of Python, such as "3.12"."""

    platform: Platform
    python: str

    def __str__(self) -> str:
        return f"{self.platform.name}, Python {self.python}"

    def markers(self) -> dict[str, str]:
        """Return what the markers of a requirement are compared with."""
        return {
            "implementation_name": "cpython",
            "implementation_version": f"{self.python}.0",
            "os_name": self.platform.os_name,
            "platform_machine": self.platform.machine,
            "platform_python_implementation": "CPython",
            "platform_release": "",
            "platform_system": self.platform.system,
            "platform_version": "",
            "python_full_version": f"{self.python}.0",
            "python_version": self.python,
            "sys_platform": self.platform.sys_platform,
        }

    @property
    def marker(self) -> str:
        """The condition of requirements that only this target has."""
        platform = self.platform
        known = {
            "sys_platform": platform.sys_platform,
            "platform_machine": platform.machine,
            "python_version": self.python,
        }
        return f"({' and '.join(f'{name} == {value!r}' for name, value in known.items())})"

    def pip_words(self) -> list[str]:
        """Return the options by which pip chooses wheels for it."""
        words = ["--only-binary=:all:", "--implementation", "cp", "--python-version", self.python]
        for tag in self.platform.tags:
            words += ["--platform", tag]
        return words


def this_platform() -> str:
    """Return the name of the platform this runs on, '' for one that is not known."""
    system = {"linux": "linux", "darwin": "macos", "win32": "windows"}.get(sys.platform, "")
    machine = {"AMD64": "x86_64", "arm64": "arm64" if system == "macos" else "aarch64"}.get(
        platform.machine(), platform.machine()
    )
    return name if (name := f"{system}-{machine}") in PLATFORMS else ""


def this_python() -> str:
    """Return the version of the Python this runs on, as in PYTHONS."""
    return f"{sys.version_info.major}.{sys.version_info.minor}"
