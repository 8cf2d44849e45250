"""The variables of a fresh login: what the simulated machine keeps of the real one's, and what names its user and home."""

from __future__ import annotations

import ntpath
import os
from collections.abc import Mapping
from pathlib import PurePath

from day6_core.places import runtime_folders

_PASSED_ON = (
    "LANG",
    "LANGUAGE",
    "LC_ALL",
    "LC_CTYPE",
    "LC_MESSAGES",
    "TZ",
    "TMPDIR",
    "TEMP",
    "TMP",
    "PATH",
    "PYTHONPATH",
    "PYTHONHASHSEED",  # in virtual time, where a run is to be the same again
    # The link's folder is derived from it: a student's process must find the same one as we do.
    "XDG_RUNTIME_DIR",
    # Without these, Windows and its programs start others badly or not at all.
    "ALLUSERSPROFILE",
    "COMMONPROGRAMFILES",
    "COMSPEC",
    "NUMBER_OF_PROCESSORS",
    "OS",
    "PATHEXT",
    "PROCESSOR_ARCHITECTURE",
    "PROGRAMDATA",
    "PROGRAMFILES",
    "PROGRAMFILES(X86)",
    "SYSTEMDRIVE",
    "SYSTEMROOT",
    "WINDIR",
)
"""Variables of the real environment that are kept, with everything that begins with ROS_, RCUTILS_, DAY6_."""


def passed_on(real: Mapping[str, str]) -> dict[str, str]:
    """Return what is kept of the real environment."""
    kept = {name: real[name] for name in _PASSED_ON if name in real}
    return kept | {name: value for name, value in real.items() if name.startswith(("ROS_", "RCUTILS_", "DAY6_"))}


def of_user(user: str, home: PurePath, system: str = os.name) -> dict[str, str]:
    """Return what names the user and the home folder, in each way in which programs of this system ask for them."""
    named = {"HOME": str(home), "USER": user, "LOGNAME": user}
    if system != "nt":
        return named
    drive, below = ntpath.splitdrive(home)
    return named | {
        "USERNAME": user,
        "USERPROFILE": str(home),
        "HOMEDRIVE": drive,
        "HOMEPATH": below,
        "APPDATA": ntpath.join(home, "AppData", "Roaming"),
        "LOCALAPPDATA": ntpath.join(home, "AppData", "Local"),
        # Otherwise it is derived from LOCALAPPDATA.
        "DAY6_RUNTIME_DIR": str(runtime_folders()[0]),
    }
