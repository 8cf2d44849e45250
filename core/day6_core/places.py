"""The folders in which day6-tui keeps this user's data, and the table of all that it writes outside of its package.

`day6-tui doctor` looks at these places, `day6-tui uninstall` removes them, and the page of the documentation is made from them.
"""

from __future__ import annotations

import os
import re
import stat
import sys
import time
from collections.abc import Callable
from pathlib import Path, PurePath
from typing import NamedTuple
from zlib import crc32

from day6_core.language import Pair

SESSION_FILE = "session.json"
"""In `.config/day6-tui` of a home: what was on the desktop when it was left."""

LEFT_BEHIND = 24 * 3600
"""Seconds after which a temporary folder that nothing has changed belongs to no program any more."""


def data_folder() -> Path:
    """Return the folder of this user's lasting data: the simulated home, copies of unsaved texts, stubs. It may not exist."""
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Application Support"
    else:
        base = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share")
    return base / "day6-tui"


def default_home() -> Path:
    """Return the folder that is `~` on the simulated machine without `--home`."""
    return data_folder() / "home"


def as_on_linux(path: PurePath) -> str:
    """Return a path as scripts and lessons write it: with slashes, and without a drive."""
    return path.as_posix()[len(path.drive) :]


def meant_in(home: Path | str, name: str) -> Path:
    """Return the path that a name means to somebody whose `~` is this folder."""
    path = Path(name)
    return Path(home, *path.parts[1:]) if path.parts[:1] == ("~",) else path


def runtime_folders() -> list[Path]:
    """Return the folders in which the processes of this user may meet, the preferred one first. They may not exist."""
    named = os.environ.get("DAY6_RUNTIME_DIR")
    if named:
        return [Path(named).absolute()]
    if sys.platform == "win32":
        return [Path(os.environ.get("LOCALAPPDATA") or Path.home()) / "day6" / "run"]
    folders = [Path(f"/tmp/day6-{os.getuid()}"), Path("~/.cache/day6-tui/run").expanduser()]
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    if runtime and os.path.isdir(runtime) and os.access(runtime, os.W_OK):
        folders.insert(0, Path(runtime) / "day6")
    return folders


def log_folder() -> Path:
    """Return the folder for the log files of programs outside the desktop, as ROS chooses it."""
    named = os.environ.get("ROS_LOG_DIR")
    return Path(named or Path(os.environ.get("ROS_HOME") or "~/.ros") / "log").expanduser()


def _sockets() -> list[Path]:
    """The folders of sockets, also those that stand in for a folder whose path is too long."""
    folders = runtime_folders()
    return [*folders, *filter(None, map(shorter_runtime_folder, folders))]


def shorter_runtime_folder(folder: Path) -> Path | None:
    """Return the folder that takes the place of one in which the path of a socket would be too long; None on Windows."""
    if sys.platform == "win32":
        return None
    return Path(f"/tmp/day6-{os.getuid()}") / f"{crc32(os.fsencode(folder)):08x}"


def _left_behind() -> list[Path]:
    """Temporary folders of programs that were killed: with the name that Python gave them, this user's, unchanged for a day."""
    import tempfile

    return sorted(Path(entry.path) for entry in os.scandir(tempfile.gettempdir()) if _is_left_behind(entry))


def _is_left_behind(entry: os.DirEntry[str]) -> bool:
    if re.fullmatch(r"(day6-(\w+-)?|d6[gls]-)(?!\d{8}$)[a-z0-9_]{8}", entry.name) is None:
        return False
    try:
        status = entry.stat(follow_symlinks=False)
    except OSError:  # it has gone
        return False
    mine = sys.platform == "win32" or status.st_uid == os.getuid()
    return mine and stat.S_ISDIR(status.st_mode) and time.time() - status.st_mtime > LEFT_BEHIND


def shortened(path: Path | str) -> str:
    """Return a path as it is shown: the home folder is ~."""
    text, home = str(path), os.path.expanduser("~")
    inside = text == home or text.startswith(home.rstrip(os.sep) + os.sep)
    return f"~{text[len(home.rstrip(os.sep)) :]}" if inside and home.rstrip(os.sep) else text


class Base(NamedTuple):
    """Where places are: the folders on this machine, and how they are written for a reader, by system."""

    find: Callable[[], list[Path]]
    linux: str
    darwin: str
    win32: str


BASES = {
    "data": Base(
        lambda: [data_folder()],
        "~/.local/share/day6-tui",
        "~/Library/Application Support/day6-tui",
        r"%LOCALAPPDATA%\day6-tui",
    ),
    "runtime": Base(
        _sockets,
        "$DAY6_RUNTIME_DIR, $XDG_RUNTIME_DIR/day6, /tmp/day6-<uid>, ~/.cache/day6-tui/run",
        "$DAY6_RUNTIME_DIR, /tmp/day6-<uid>, ~/.cache/day6-tui/run",
        r"%DAY6_RUNTIME_DIR%, %LOCALAPPDATA%\day6\run",
    ),
    "system": Base(lambda: [Path("/run/day6-tui")], "/run/day6-tui", "", ""),
    "temporary": Base(
        _left_behind, "$TMPDIR/day6-*, $TMPDIR/d6*", "$TMPDIR/day6-*, $TMPDIR/d6*", r"%TEMP%\day6-*, %TEMP%\d6*"
    ),
    "logs": Base(
        lambda: [log_folder()],
        "~/.ros/log",
        "~/.ros/log",
        r"~\.ros\log",
    ),
    "user": Base(lambda: [Path.home()], "~", "~", "~"),
    "desktop": Base(lambda: [default_home()], "~", "~", "~"),
}
"""`desktop` is the folder that is ~ in the terminals of the desktop."""


class Place(NamedTuple):
    """Something that day6-tui writes."""

    name: str
    base: str
    """A key of BASES."""
    below: str
    """A path below the base, in which * stands for any name; '' for the base itself."""
    whose: str
    """'ours': `uninstall --data` removes it; 'user': the user's work, removed by `--files` only; 'ros': a real ROS has it."""
    text: Pair
    """What it is."""
    files: str = ""
    """A regular expression of the paths in it (with /) that are ours, where a name says so; '' where everything is."""
    mark: str = ""
    """What has to be in it, or it is somebody else's."""

    def found(self) -> list[Path]:
        """Return where it is on this machine."""
        paths: list[Path] = []
        for base in BASES[self.base].find():
            paths += sorted(base.glob(self.below)) if self.below else [base]
        there = [path for path in dict.fromkeys(paths) if os.path.lexists(path)]
        return [path for path in there if not self.mark or (path / self.mark).exists()]

    def shown(self, system: str) -> str:
        """Return how it is written for a reader on 'linux', 'darwin' or 'win32'; '' if it does not exist there."""
        base: str = getattr(BASES[self.base], system)
        path = f"{base}/{self.below}" if base and self.below else base
        return path.replace("/", "\\") if system == "win32" else path


_DOMAIN = r"\d{1,3}(/(meet(ing)?(\.lock)?|gate\.lock|port|secret|users|(p|doors|guests)-[\w.-]+|\.day6-[0-9a-f]{12}))?"
_MEETING = rf"({_DOMAIN}|desktop-[0-9a-f]{{8}}(\.lock)?)"
_OF_SERVER = rf"(lock|p(/[0-9a-f]{{8}}(/{_MEETING})?)?|k(/{_MEETING})?)"
_SOCKETS = rf"([0-9a-f]{{8}}/)?(c[0-9a-f]{{8}}(/{_OF_SERVER})?|{_MEETING}|[0-9a-f]{{8}})"

PLACES = (
    Place(
        "settings",
        "data",
        "settings.json",
        "ours",
        ("what was chosen in the desktop: theme, distribution …", "在桌面里选过的设置：主题、发行版等"),
    ),
    Place(
        "executables",
        "data",
        "bin-*",
        "ours",
        (
            "ros2, colcon, python3 … as executables, a folder for each interpreter",
            "ros2、colcon、python3 等可执行文件，每个解释器一个文件夹",
        ),
        files=r"[\w.-]+",
    ),
    Place(
        "executables_begun",
        "data",
        ".bin-*",
        "ours",
        ("the same, of a program that was killed meanwhile", "同上，创建时程序被强行结束留下的"),
        files=r"[\w.-]+",
    ),
    Place(
        "stubs",
        "data",
        "stubs*",
        "ours",
        (
            "what editors need to know messages (day6-tui env --vscode)",
            "编辑器认识消息类型所需的文件（day6-tui env --vscode）",
        ),
        files=r"\w+(/__init__\.pyi|/(msg|srv|action)(/__init__\.pyi)?)?|(\w+/){0,2}\.day6-[0-9a-f]{12}",
    ),
    Place(
        "sockets",
        "runtime",
        "",
        "ours",
        ("sockets by which programs meet", "程序之间互相连接用的套接字"),
        files=_SOCKETS,
    ),
    Place(
        "users",
        "system",
        "",
        "ours",
        (
            "sockets and user numbers of serve --isolation users (root)",
            "serve --isolation users 的套接字和用户编号（root）",
        ),
        files=rf"uids(/\d+)?|{_SOCKETS}",
    ),
    Place(
        "temporary",
        "temporary",
        "",
        "ours",
        ("temporary folders of programs that were killed", "被强行结束的程序留下的临时文件夹"),
    ),
    Place(
        "home",
        "data",
        "home",
        "user",
        (
            "the desktop's ~: programs, workspace, progress, layout",
            "桌面的 ~：程序、工作空间、进度、布局",
        ),
    ),
    Place(
        "state",
        "desktop",
        ".config/day6-tui",
        "user",
        (
            "in each such folder: progress in lessons (pupils), layout and terminals of the desktop",
            "每个这样的文件夹里：课程进度（pupils），桌面的布局和终端",
        ),
    ),
    Place(
        "packages",
        "desktop",
        ".local/lib/day6-tui",
        "user",
        (
            "in each such folder: what pip has installed for the programs there",
            "每个这样的文件夹里：pip 给那里的程序安装的包",
        ),
    ),
    Place("history", "desktop", ".bash_history", "user", ("lines typed in its terminals", "在它的终端里输入过的命令")),
    Place("unsaved", "data", "unsaved", "user", ("copies of texts that were not saved", "没有保存的文本的副本")),
    Place(
        "class",
        "data",
        "class",
        "user",
        (
            "day6-tui serve without --data: homes of pupils, links",
            "没有 --data 的 day6-tui serve：学生的主目录、链接",
        ),
    ),
    Place(
        "jupyter",
        "user",
        "day6",
        "user",
        ("~ of the desktop in JupyterLab", "JupyterLab 里桌面的 ~"),
        mark=".config/day6-tui",
    ),
    Place(
        "packages_of_shell",
        "user",
        ".local/lib/day6-tui",
        "user",
        ("what pip has installed in day6-tui shell", "pip 在 day6-tui shell 里安装的包"),
    ),
    Place(
        "perspectives",
        "user",
        ".config/ros.org/rqt_gui",
        "user",
        ("perspectives of day6-tui rqt outside the desktop", "桌面之外的 day6-tui rqt 的 perspective"),
    ),
    Place(
        "logs",
        "logs",
        "",
        "ros",
        ("log files of programs outside the desktop", "桌面之外的程序的日志文件"),
    ),
)
"""What a user names is not in here: folders of --home, --data and wheelhouse, bags, recordings, .vscode and .idea of projects."""
