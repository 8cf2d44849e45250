"""Walks docs/en/teachers/jupyterhub.md with a real JupyterHub, two pupils and a real browser.

    python -m tests.web.try_hub BIN PROXY FOLDER

BIN is the bin folder of an environment with jupyterhub, jupyterlab, jupyter-server-proxy and day6-tui[serve], PROXY that of
configurable-http-proxy; screenshots go to FOLDER. Prints PSS and CPU of the hub, its proxy and a pupil's server, and when the
desktop is on the screen; fails if one pupil's turtle is seen by the other, if the first notebook does not drive the turtle of its
pupil's desktop, or if the word lets in the teacher.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.support.free_port import free_port
from tests.web.background import Background
from tests.web.chromium import Chromium, Page, program

WORD = "chalk-and-sponge"
TEACHER_WORD = "a sentence that only the teacher knows"
HUB = Path(__file__).resolve().parents[2] / "hub"
CONFIG, NOTEBOOK = HUB / "jupyterhub_config.py", HUB / "first_steps.ipynb"
PARTS = {
    "hub": b"bin/jupyterhub\0",
    "proxy": b"configurable-http-proxy",
    "pupil's server": b"singleuser",
    "serve": b"day6_tui.main\0serve",
    "desktop": b"day6_tui.main\0--",
}


def main() -> None:
    tools, proxy, folder = Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3])
    executable = program()
    if executable is None:
        sys.exit("there is no Chromium here")
    folder.mkdir(parents=True, exist_ok=True)
    home = tempfile.mkdtemp(prefix="day6-hub-")
    port = free_port()
    address = f"http://127.0.0.1:{port}"
    environ = {
        **os.environ,
        "PATH": os.pathsep.join([str(tools), proxy, os.environ["PATH"]]),
        "DAY6_HUB_WORD": WORD,
        "DAY6_HUB_TEACHER_WORD": TEACHER_WORD,
        "DAY6_HUB_URL": address,
        "DAY6_HUB_AS_ROOT": "1",  # this is run as root, too
    }
    with open(folder / "hub.log", "w", encoding="utf-8") as log:
        hub = subprocess.Popen(
            [str(tools / "jupyterhub"), "-f", str(CONFIG)], cwd=home, env=environ, stdout=log, stderr=subprocess.STDOUT
        )
    background = Background()
    browser = Chromium(executable, background)
    try:
        pages = {name: browser.page() for name in ("anna", "ben")}
        measure("the hub alone")
        for name, page in pages.items():
            log_in(page, address, name)
            page.screenshot(folder / f"{name}-lab.png")
        measure("two pupils in JupyterLab")
        for name, page in pages.items():
            began = time.monotonic()
            page.navigate(f"{address}/user/{name}/day6/")
            page.wait_for("Boolean(window.desk) && desk._connection.isOpen", 90)
            print(f"{name}: the desktop is there after {time.monotonic() - began:.1f} s")
        time.sleep(4)
        type_line(pages["anna"], "ros2 run turtlesim turtlesim_node")
        type_line(pages["ben"], "ros2 node list; echo nodes-$((40+2))")
        time.sleep(6)
        for name, page in pages.items():
            page.screenshot(folder / f"{name}-desktop.png")
        seen = screen(pages["ben"])
        assert "nodes-42" in seen, seen
        assert "/turtlesim" not in seen, "ben sees anna's turtle"
        measure("two desktops")
        drive_by_notebook(browser.page(), address, pages["anna"], folder)
        refuse_the_pupils_word(browser.page(), address)
    finally:
        browser.close()
        background.close()
        hub.terminate()
        hub.wait(90)
    time.sleep(3)
    left = [name for name in filter(str.isdigit, os.listdir("/proc")) if belongs(name, home)]
    print(f"processes left: {len(left)}")


def enter(page: Page, address: str, name: str, word: str) -> None:
    """Fill in the page on which everybody logs in, as soon as the hub has it."""
    page.device(1280, 800)
    end = time.monotonic() + 60
    while time.monotonic() < end:
        page.navigate(f"{address}/hub/login")
        if page.evaluate("Boolean(document.querySelector('#username_input'))"):
            break
        time.sleep(0.5)
    page.evaluate(
        f"document.querySelector('#username_input').value = {name!r};"
        f"document.querySelector('#password_input').value = {word!r};"
        "document.querySelector('form').submit()"
    )


def log_in(page: Page, address: str, name: str) -> None:
    enter(page, address, name, WORD)
    page.wait_for("location.pathname.includes('/lab') && document.body.innerText.includes('ROS 2')", 120)


def drive_by_notebook(page: Page, address: str, desk: Page, folder: Path) -> None:
    """Run the first notebook as far as it drives the turtle, which stands on anna's desktop."""
    assert "x 5.54" in screen(desk), screen(desk)
    cells = json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]
    last = next(number for number, cell in enumerate(cells) if "driver = Driver()" in cell["source"])
    log_in(page, address, "anna")
    page.navigate(f"{address}/user/anna/lab/tree/{NOTEBOOK.name}")
    page.wait_for("document.body.innerText.includes('Python 3 (ipykernel) | Idle')", 60)
    page.click_on(".jp-MarkdownOutput")
    page.press("Escape")
    for _ in range(last + 1):
        page.press("Enter", "shift")
        time.sleep(1)
    page.wait_for("document.body.innerText.includes('driver.destroy_node() ends it')", 30)
    time.sleep(4)
    page.screenshot(folder / "anna-notebook.png")
    desk.screenshot(folder / "anna-driven.png")
    assert "x 5.54" not in screen(desk), screen(desk)
    print("the notebook drives the turtle of the desktop")


def refuse_the_pupils_word(page: Page, address: str) -> None:
    enter(page, address, "teacher", WORD)
    page.wait_for("document.body.innerText.includes('Invalid username or password')")
    enter(page, address, "teacher", TEACHER_WORD)
    page.wait_for("location.pathname.includes('/lab')", 120)
    page.navigate(f"{address}/hub/admin")
    page.wait_for("document.body.innerText.includes('anna')", 20)
    print("the teacher has a word, and sees the pupils")


def type_line(page: Page, text: str) -> None:
    page.ask("Input.insertText", text=text)
    page.press("Enter")


def screen(page: Page) -> str:
    """The text on a desktop's screen."""
    return str(
        page.evaluate(
            "(() => { const b = desk._terminal.buffer.active; let out = '';"
            " for (let y = 0; y < b.length; y++) out += b.getLine(y).translateToString() + '\\n'; return out; })()"
        )
    )


def measure(what: str) -> None:
    """Print PSS and the CPU of five seconds of each part."""
    before = taken()
    time.sleep(5)
    after = taken()
    print(f"{what}:")
    for part in PARTS:
        found = [pid for pid in after if after[pid][0] == part]
        if found:
            pss = sum(after[pid][1] for pid in found) / 1024
            used = sum(after[pid][2] - before.get(pid, after[pid])[2] for pid in found) / 5 * 100
            print(f"  {part}: {len(found)} processes, {pss:.0f} MB PSS, {used:.1f} % of a core")


def taken() -> dict[str, tuple[str, int, float]]:
    """Part, kB of PSS and seconds of CPU by process."""
    found = {}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = Path("/proc", pid, "cmdline").read_bytes()
            part = next((name for name, mark in PARTS.items() if mark in words), None)
            if part is None:
                continue
            lines = Path("/proc", pid, "smaps_rollup").read_text(encoding="ascii").splitlines()
            fields = Path("/proc", pid, "stat").read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()
        except OSError:
            continue
        pss = next(int(line.split()[1]) for line in lines if line.startswith("Pss:"))
        found[pid] = (part, pss, (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK"))
    return found


def belongs(process: str, home: str) -> bool:
    try:
        return os.fsencode(home) in Path("/proc", process, "cmdline").read_bytes()
    except OSError:
        return False


if __name__ == "__main__":
    main()
