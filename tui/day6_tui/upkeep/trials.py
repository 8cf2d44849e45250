"""What the checks of the doctor try: files, sockets, imports, programs. All of it is bounded, and cleaned up."""

from __future__ import annotations

import contextlib
import json
import os
import re
import socket
import subprocess
import sys
import tempfile
import time
from importlib.metadata import PackageNotFoundError, distribution
from importlib.metadata import version as installed_version
from pathlib import Path
from typing import NamedTuple

from day6_core.reason import reason
from day6_core.ros.environment import program_environment
from day6_tui.upkeep.installation import NAME

MODULES = (
    *("textual", "rich", "numpy", "yourdfpy", "yaml", "PIL", "reportlab", "zenoh", "tree_sitter", "tree_sitter_python"),
    *(
        "tree_sitter_xml",
        "tree_sitter_yaml",
        "xacro",
        "catkin_pkg",
        "mcap",
        "zstandard",
        "xxhash",
        "packaging",
        "pytest",
    ),
    "setuptools",
)
"""What day6-tui imports of others."""

START_SECONDS = 25.0
"""What a Python with rclpy may take to start on a slow machine."""


class Requirement(NamedTuple):
    """A package that was declared, and what is there."""

    name: str
    wanted: str
    version: str | None
    fits: bool
    extra: str = ""
    """The option of the installation that it belongs to."""


def requirements() -> list[Requirement]:
    """Return what the package needs; empty if it is not installed. Packages of tests are left out."""
    from packaging.requirements import Requirement as Declared

    try:
        declared = [Declared(text) for text in distribution(NAME).requires or ()]
    except PackageNotFoundError:
        return []
    found = []
    for each in declared:
        extra = re.search(r"extra == ['\"](\w+)", str(each.marker or ""))
        if (extra is not None and extra[1] != "serve") or (
            extra is None and each.marker and not each.marker.evaluate()
        ):
            continue
        try:
            version: str | None = installed_version(each.name)
        except PackageNotFoundError:
            version = None
        fits = version is not None and each.specifier.contains(version, prereleases=True)
        found.append(Requirement(each.name, str(each.specifier), version, fits, extra[1] if extra else ""))
    return found


def failing_imports(modules: tuple[str, ...] = MODULES, seconds: float = 50.0) -> dict[str, str]:
    """Import modules in a Python of its own; return those that fail, with the reason. Raises TimeoutError."""
    code = (
        "import importlib, json, sys\nfailed = {}\n"
        "for name in sys.argv[1:]:\n"
        "    try:\n        importlib.import_module(name)\n"
        "    except Exception as error:\n        failed[name] = f'{type(error).__name__}: {error}'\n"
        "print(json.dumps(failed))\n"
    )
    path = os.pathsep.join(entry for entry in sys.path if entry)
    done = _run([sys.executable, "-c", code, *modules], {**os.environ, "PYTHONPATH": path}, seconds)
    if done.returncode:
        return {"python": _last_line(done.stderr) or f"status {done.returncode}"}
    failed: dict[str, str] = json.loads(done.stdout.splitlines()[-1])
    return failed


def cannot_write(folder: Path) -> str:
    """Write a file, read it, remove it; return why that cannot be done, '' if it can."""
    try:
        with tempfile.NamedTemporaryFile(dir=folder, prefix=".day6-doctor-") as file:
            file.write(b"day6-tui")
            file.flush()
            file.seek(0)
            return "" if file.read() == b"day6-tui" else "?"
    except OSError as error:
        return reason(error)


def meet(folder: Path | None) -> None:
    """Listen in a folder (None: at a TCP port of this machine), connect, send a byte. Raises OSError."""
    if folder is None or sys.platform == "win32":
        listener = socket.create_server(("127.0.0.1", 0))
        path = ""
    else:
        path = str(folder / f".day6-{os.urandom(6).hex()}")
        listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        listener.bind(path)
        listener.listen(1)
    try:
        with listener, socket.socket(listener.family, socket.SOCK_STREAM) as caller:
            for each in (listener, caller):
                each.settimeout(5.0)
            caller.connect(listener.getsockname())
            connection, _ = listener.accept()
            with connection:
                caller.sendall(b"6")
                connection.settimeout(5.0)
                if connection.recv(1) != b"6":
                    raise OSError("nothing arrives")
    finally:
        if path:
            with contextlib.suppress(OSError):
                os.unlink(path)


_TALKER = """\
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("day6_doctor_talker")
publisher = node.create_publisher(String, "day6_doctor", 10)
node.create_timer(0.1, lambda: publisher.publish(String(data="day6-tui")))
rclpy.spin(node)
"""

_LISTENER = """\
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("day6_doctor_listener")
heard = []
node.create_subscription(String, "day6_doctor", lambda message: heard.append(message.data), 10)
while not heard:
    rclpy.spin_once(node)
print(heard[0])
"""


def one_message(seconds: float = 2 * START_SECONDS) -> str:
    """Let one program publish and another one listen; return why no message arrived, '' if it did.

    They meet in a folder of their own, so that nobody sees them on the graph.
    """
    short = None if os.name == "nt" else "/tmp"
    with tempfile.TemporaryDirectory(prefix="day6-doctor-", dir=short, ignore_cleanup_errors=True) as folder:
        environment = program_environment()
        environment |= {"DAY6_RUNTIME_DIR": folder, "ROS_DOMAIN_ID": "0", "ROS_LOG_DIR": str(Path(folder, "log"))}
        for name in (
            "ROS_AUTOMATIC_DISCOVERY_RANGE",
            "DAY6_WATCH",
            *(["DAY6_LINK"] if environment.get("DAY6_LINK") == "off" else []),
        ):
            environment.pop(name, None)
        talking, listening = ([sys.executable, "-c", program] for program in (_TALKER, _LISTENER))
        with _Child(talking, environment, folder) as talker, _Child(listening, environment, folder) as listener:
            end = time.monotonic() + seconds
            while listener.poll() is None and talker.poll() is None and time.monotonic() < end:
                time.sleep(0.05)
            if talker.poll() is not None:
                return talker.said() or f"status {talker.poll()}"
            if listener.poll() is None:
                return "timeout"
            return "" if listener.poll() == 0 else listener.said() or f"status {listener.poll()}"


class _Child:
    """A program whose output goes to a file, and which is ended with the block."""

    def __init__(self, argv: list[str], environment: dict[str, str], folder: str) -> None:
        self._output = tempfile.TemporaryFile(dir=folder)  # noqa: SIM115 - closed at the end of the block
        self._process = subprocess.Popen(
            argv, env=environment, cwd=folder, stdin=subprocess.DEVNULL, stdout=self._output, stderr=self._output
        )

    def __enter__(self) -> _Child:
        return self

    def __exit__(self, *error: object) -> None:
        self._process.kill()
        self._process.wait()
        self._output.close()

    def poll(self) -> int | None:
        """The status, None while it runs."""
        return self._process.poll()

    def said(self) -> str:
        """Its last line."""
        self._output.seek(0)
        return _last_line(self._output.read().decode(errors="replace"))


def _run(argv: list[str], environment: dict[str, str], seconds: float) -> subprocess.CompletedProcess[str]:
    """Raises TimeoutError."""
    try:
        return subprocess.run(
            argv,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            encoding="utf-8",
            errors="replace",
            timeout=seconds,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise TimeoutError(f"{Path(argv[0]).name}: {seconds:.0f} s") from None


def _last_line(text: str) -> str:
    return next((line.strip() for line in reversed(text.splitlines()) if line.strip()), "")
