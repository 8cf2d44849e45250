"""Makes a wheelhouse with the real pip and installs from it without any index: python -m tests.wheelhouse.try_offline

Needs a package index for the first half. Prints what it does; exit status 0 if the installed day6-tui runs.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import venv
from pathlib import Path


def run(*words: object, env: dict[str, str] | None = None, cwd: Path | None = None) -> None:
    print("$", *words, flush=True)
    subprocess.run([str(word) for word in words], check=True, env=env, cwd=cwd)


def main() -> None:
    with tempfile.TemporaryDirectory(prefix="day6-offline-") as name:
        place = Path(name)
        stick, home = place / "stick", place / "home"
        run(sys.executable, "-m", "day6_tui.main", "wheelhouse", stick, "--lang", "en")
        # An index or a folder of wheels from the user's configuration would hide what is missing.
        env = {key: value for key, value in os.environ.items() if not key.startswith("PIP_")}
        env["PIP_CONFIG_FILE"] = os.devnull
        venv.create(home, with_pip=True)
        programs = home / ("Scripts" if os.name == "nt" else "bin")
        run(sys.executable, "check.py", cwd=stick)
        line = re.findall(r"bin/(pip install .*)", (stick / "INSTALL.txt").read_text(encoding="utf-8"))[0]
        run(programs / "pip", *line.split()[1:], env=env, cwd=stick)
        run(programs / "day6-tui", "--version", env=env, cwd=place)
        run(programs / "day6-tui", "exec", "-c", "ros2 topic list", env=env, cwd=place)
        run(programs / "day6-tui", "wheelhouse", place / "again", "--lang", "en", cwd=place)


if __name__ == "__main__":
    main()
