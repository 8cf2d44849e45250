"""Records what programs do with a real rclpy: `python record.py /path/to/python-with-real-rclpy PROGRAM.py …`.

Each program is run in an empty folder; its outcome is added to recorded.jsonl under its file's name, replacing an older one.
Without programs everything that is recorded is recorded anew.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, os.path.dirname(__file__))

from golden import RECORDED, SITE


def record(python: str, name: str, code: str, domain: int) -> dict[str, object]:
    """Run one program with a real rclpy; returns the entry for recorded.jsonl."""
    env = {
        key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "RCUTILS_CONSOLE_OUTPUT_FORMAT")
    }
    # Our messages are always checked, so the real ones are too.
    env.update(ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST", ROS_PYTHON_CHECK_FIELDS="1", ROS_DOMAIN_ID=str(domain))
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "prog.py").write_text(code, encoding="utf-8")
        done = subprocess.run(
            [python, "prog.py"],
            cwd=folder,
            env=env,
            capture_output=True,
            text=True,
            timeout=120,
            stdin=subprocess.DEVNULL,
        )
        site = str(Path(python).absolute().parents[1] / "lib" / "python3.11" / "site-packages")

        def even(text: str) -> str:
            return text.replace(f"{folder}{os.sep}", "").replace(site, SITE)

        return {
            "name": name,
            "code": code,
            "stdout": even(done.stdout),
            "stderr": even(done.stderr),
            "exit_code": done.returncode,
        }


def main(python: str, programs: list[str]) -> None:
    """Record the programs, or all again."""
    entries = {}
    if RECORDED.is_file():
        lines = RECORDED.read_text(encoding="utf-8").splitlines()
        entries = {entry["name"]: entry for entry in map(json.loads, lines)}
    codes = {Path(path).stem: Path(path).read_text(encoding="utf-8") for path in programs}
    if not codes:
        codes = {name: entry["code"] for name, entry in entries.items()}
    for number, (name, code) in enumerate(codes.items()):
        print(name)
        entries[name] = record(python, name, code, 20 + number % 80)
    text = "".join(json.dumps(entries[name], ensure_ascii=False) + "\n" for name in sorted(entries))
    RECORDED.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
