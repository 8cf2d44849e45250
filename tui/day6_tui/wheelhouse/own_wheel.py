"""The wheel of the day6-tui that runs: built from its sources if it was installed from them, else from what was installed."""

from __future__ import annotations

import base64
import hashlib
import json
import subprocess
import sys
import zipfile
from importlib.metadata import Distribution, PackagePath, distributions
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

NAME = "day6-tui"
LEFT_OUT = ("INSTALLER", "REQUESTED", "direct_url.json", "RECORD", "uv_cache.json")
"""What an installer adds to the metadata."""


class WheelError(Exception):
    """It cannot be made; the message is that of what failed."""


def make(folder: Path) -> Path:
    """Make the wheel in an empty folder and return it. Raises WheelError, OSError."""
    found = next((each for each in distributions(name=NAME) if _said(each, "METADATA")), None)
    if found is None:
        raise WheelError("what is installed has no list of its files")
    root = _sources(found)
    return _rebuilt(found, folder) if root is None else _built(root, folder)


def _sources(found: Distribution) -> Path | None:
    """The folder of an editable installation."""
    origin = json.loads(_said(found, "direct_url.json") or "{}")
    if not origin.get("dir_info", {}).get("editable"):
        return None
    return Path(url2pathname(urlsplit(origin["url"]).path))


def _said(found: Distribution, name: str) -> str:
    """A file of the metadata; '' if it is not there."""
    file = next(
        (each for each in found.files or () if each.name == name and each.parts[0].endswith(".dist-info")), None
    )
    return file.read_text(encoding="utf-8") if file is not None else ""


def _built(root: Path, folder: Path) -> Path:
    words = ["wheel", "--quiet", "--no-deps", "--wheel-dir", str(folder), str(root)]
    done = subprocess.run(
        [sys.executable, "-m", "pip", "--disable-pip-version-check", *words],
        capture_output=True,
        encoding="utf-8",
        errors="replace",
        stdin=subprocess.DEVNULL,
    )
    wheels = list(folder.glob("*.whl"))
    if done.returncode or not wheels:
        raise WheelError(done.stderr.strip().rpartition("\n")[2] or f"pip wheel: {done.returncode}")
    return wheels[0]


def _rebuilt(found: Distribution, folder: Path) -> Path:
    """A wheel with the files that were installed from one."""
    files = [each for each in found.files or () if _belongs(each)]
    info = next(each.parts[0] for each in files if each.name == "METADATA")
    lines = (_said(found, "WHEEL") or "Tag: py3-none-any").splitlines()
    tag = next(line[5:] for line in lines if line[:5] == "Tag: ")
    wheel = folder / f"{NAME.replace('-', '_')}-{found.version}-{tag}.whl"
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as packed:
        for each in sorted(files, key=str):
            data = Path(str(each.locate())).read_bytes()
            name = each.as_posix()
            packed.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}")
        record.append(f"{info}/RECORD,,")
        packed.writestr(zipfile.ZipInfo(f"{info}/RECORD", (1980, 1, 1, 0, 0, 0)), "\n".join(record) + "\n")
    return wheel


def _belongs(file: PackagePath) -> bool:
    if ".." in file.parts or "__pycache__" in file.parts:  # scripts, which pip makes; what Python compiled
        return False
    return not (file.parts[0].endswith(".dist-info") and file.name in LEFT_OUT)
