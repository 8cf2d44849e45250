"""Opens the tile in a real JupyterLab, in a real browser: python -m tests.web.try_jupyter JUPYTER FOLDER

JUPYTER is the `jupyter` of an environment with jupyterlab, jupyter-server-proxy and day6-tui[serve]; screenshots go to FOLDER.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.support.free_port import free_port
from tests.web.background import Background
from tests.web.chromium import Chromium, program


def main() -> None:
    jupyter, folder = sys.argv[1], Path(sys.argv[2])
    executable = program()
    if executable is None:
        sys.exit("there is no Chromium here")
    folder.mkdir(parents=True, exist_ok=True)
    home = tempfile.mkdtemp(prefix="day6-jupyter-")
    port = free_port()
    words = ["lab", "--no-browser", "--allow-root", f"--port={port}", "--IdentityProvider.token=x"]
    environ = {**os.environ, "HOME": home, "DAY6_RUNTIME_DIR": f"{home}/run"}
    with open(folder / "jupyter.log", "w", encoding="utf-8") as log:
        lab = subprocess.Popen([jupyter, *words], cwd=home, env=environ, stdout=log, stderr=subprocess.STDOUT)
    background = Background()
    browser = Chromium(executable, background)
    try:
        page = browser.page()
        page.device(1280, 800)
        end = time.monotonic() + 60
        while time.monotonic() < end:
            page.navigate(f"http://127.0.0.1:{port}/lab?token=x")
            if page.evaluate("location.pathname.startsWith('/lab')"):
                break
            time.sleep(0.5)
        page.wait_for("document.body.innerText.includes('ROS 2')", 60)
        page.screenshot(folder / "launcher.png")
        began = time.monotonic()
        page.navigate(f"http://127.0.0.1:{port}/day6/")
        page.wait_for("Boolean(window.desk) && desk._connection.isOpen", 60)
        print(f"the desktop is there after {time.monotonic() - began:.1f} s")
        time.sleep(3)
        page.screenshot(folder / "desktop.png")
    finally:
        browser.close()
        background.close()
        lab.terminate()
        lab.wait(30)
    left = [name for name in filter(str.isdigit, os.listdir("/proc")) if _belongs(name, home)]
    print(f"processes left: {len(left)}")


def _belongs(process: str, home: str) -> bool:
    try:
        return os.fsencode(home) in Path("/proc", process, "cmdline").read_bytes()
    except OSError:
        return False


if __name__ == "__main__":
    main()
