"""Records what the real `ros2 launch` does: `python record.py PYTHON SITE [FOLDER …]`.

PYTHON has a real rclpy. SITE is a folder with the Python packages of the real launch, launch_ros, launch_xml, launch_yaml,
ros2cli, ros2launch with their metadata and what they need; below its `share` are launch's grammar and its marker in the ament
index. Each FOLDER is a case: its files, and `case.json` for what `launch_cases.Case` has beside them. It is added to
recorded.jsonl under the folder's name, replacing an older one. Without folders everything is recorded anew.
"""

from __future__ import annotations

import dataclasses
import json
import os
import sys
import tempfile
from pathlib import Path

from tests.launch.launch_cases import RECORDED, Case, load_cases, play


def read_case(folder: Path) -> Case:
    """Return the case of a folder."""
    files = {
        str(path.relative_to(folder)): path.read_text(encoding="utf-8")
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name != "case.json"
    }
    options = folder / "case.json"
    return Case(folder.name, files, **(json.loads(options.read_text(encoding="utf-8")) if options.exists() else {}))


def record(case: Case, python: str, site: str, domain: int) -> Case:
    """Play a case with the real launch."""
    env = {
        **os.environ,
        "PYTHONPATH": site,
        "AMENT_PREFIX_PATH": site,
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_DOMAIN_ID": str(domain),
    }
    env["PATH"] = f"{Path(python).parent}{os.pathsep}{env['PATH']}"
    command = [python, "-c", "import sys; from ros2cli.cli import main; sys.argv[0] = 'ros2'; sys.exit(main())"]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        return dataclasses.replace(case, expected=play(case, Path(folder), command, env))


def main(python: str, site: str, folders: list[str]) -> None:
    """Record the cases of the folders, or all again."""
    cases = {case.name: case for case in load_cases()} if RECORDED.is_file() else {}
    wanted = [read_case(Path(folder)) for folder in folders] or list(cases.values())
    for number, case in enumerate(wanted):
        print(case.name, flush=True)
        cases[case.name] = record(case, python, site, 20 + number % 80)
        lines = (json.dumps(dataclasses.asdict(cases[name]), ensure_ascii=False) for name in sorted(cases))
        RECORDED.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
