"""A class in a real browser, to be looked at: python -m tests.web.play_class FOLDER [--pupils 8] [--isolation auto] [--lang zh]

Every pupil has a browser tab with a profile of its own and plays the first lesson; the teacher's page is open beside them, with
all screens in small. Two more pupils are on the list and never come; for one without a place the class is full. Screenshots go
to FOLDER.
Prints what the server and the desktops took of a core meanwhile, and the seconds until a reloaded tab shows its desktop again.
Needs Chromium and the extra `serve`.
"""

from __future__ import annotations

import argparse
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.web.background import Background
from tests.web.chromium import Chromium, Page, program

WORD = "turtle"
LANGUAGES = {"zh": "zh-CN", "en": "en-US"}
MISSING = ("韩梅梅", "李雷")


def cpu_of(marks: tuple[bytes, ...]) -> dict[str, float]:
    """Seconds of CPU that processes have taken, by what their command lines hold."""
    taken = dict.fromkeys(map(os.fsdecode, marks), 0.0)
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = Path("/proc", name, "cmdline").read_bytes()
            fields = (
                Path("/proc", name, "stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
            )
        except OSError:
            continue
        for mark in marks:
            if mark in words:
                taken[os.fsdecode(mark)] += (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
                break
    return taken


def enter(page: Page, base: str, name: str) -> None:
    """What a pupil does on the start page."""
    page.navigate(base)
    page.wait_for("document.querySelector('input[name=word]') !== null")
    page.evaluate(
        f"document.querySelector('input[name=word]').value = {WORD!r};"
        f"document.querySelector('input[name=name]').value = {name!r};"
        "document.querySelector('form').submit()"
    )
    page.wait_for("location.pathname.endsWith('/desk')")


def class_list(place: str) -> Path:
    """The two who do not come, whose places are kept; the others choose their names."""
    file = Path(place, "class.csv")
    file.write_text("".join(f"{name}\n" for name in MISSING), encoding="utf-8")
    return file


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--pupils", type=int, default=8)
    parser.add_argument("--isolation", default="auto")
    parser.add_argument("--lang", choices=tuple(LANGUAGES), default="zh")
    parser.add_argument("--seconds", type=float, default=60)
    options = parser.parse_args()
    executable = program()
    if executable is None:
        sys.exit("there is no Chromium here")
    options.folder.mkdir(parents=True, exist_ok=True)
    place = tempfile.mkdtemp(prefix="day6-play-")
    words = ["serve", "--word", WORD, "--class", str(class_list(place)), "--most", str(options.pupils + len(MISSING))]
    words += [
        "--unasked",
        str(options.pupils + 1),
        "--port",
        "0",
        "--data",
        f"{place}/class",
        "--isolation",
        options.isolation,
    ]
    server = subprocess.Popen(
        [sys.executable, "-m", "day6_tui.main", *words, "--lang", options.lang],
        stdout=subprocess.PIPE,
        text=True,
        encoding="utf-8",
        env={**os.environ, "DAY6_RUNTIME_DIR": f"{place}/run"},
    )
    assert server.stdout is not None
    links: list[str] = []
    for line in server.stdout:
        print(line, end="")
        links += re.findall(r"http://\S+[\w/-]", line)
        if len(links) > len(MISSING) + 1:
            break
    *_, teacher, base = links  # in the order in which the server tells them
    background = Background()
    browser = Chromium(executable, background, (f"--accept-lang={LANGUAGES[options.lang]}",))
    try:
        front = browser.page()
        front.device(1280, 800)
        front.navigate(base)
        front.screenshot(options.folder / "start.png")
        front.navigate(teacher)
        front.wait_for("location.pathname.endsWith('/class')")
        pupils = [browser.page() for _ in range(options.pupils)]
        for number, page in enumerate(pupils):
            page.device(1280, 800)
            enter(page, base, f"学生{number + 1}")
        for page in pupils:
            page.wait_for("document.querySelector('.xterm') !== null")
        front.wait_for(f"document.querySelectorAll('.pupil[data-state=here]').length === {options.pupils}")
        outside = browser.page()
        enter(outside, base, f"学生{options.pupils + 1}")
        front.wait_for("document.querySelector('.pupil[data-state=full]') !== null")
        time.sleep(3)
        front.evaluate("document.querySelector('#screens').checked || document.querySelector('#screens').click()")
        front.evaluate("window.confirm = () => true")
        front.evaluate(
            "(() => { const s = document.querySelector('#start');"
            "const o = [...s.options].find((o) => o.value.includes('day1'));"
            "s.value = o.value; s.dispatchEvent(new Event('change')) })()"
        )
        front.wait_for("document.querySelectorAll('.pupil progress:not([hidden])').length > 0")
        time.sleep(3)
        marks = (b"tui.main\0serve", b"day6_tui.detached", b"day6_tui.main", b"chromium")
        before, began = cpu_of(marks), time.monotonic()
        for page in pupils:
            page.press("F5")
            time.sleep(0.3)
            page.press("D")
        while time.monotonic() - began < options.seconds:
            time.sleep(options.seconds / 4)
            front.screenshot(options.folder / f"class-{time.monotonic() - began:.0f}.png")
            pupils[0].screenshot(options.folder / f"pupil-{time.monotonic() - began:.0f}.png")
        took = time.monotonic() - began
        for name, seconds in cpu_of(marks).items():
            share = 100 * (seconds - before[name]) / took
            print(f"{name!r:40} {share:6.1f} % of a core over {took:.0f} s, {share / options.pupils:.2f} % a pupil")
        started = time.monotonic()
        pupils[1].reload()
        pupils[1].wait_for("document.querySelector('.xterm-rows, .xterm canvas') !== null")
        print(f"a reloaded tab: {time.monotonic() - started:.2f} s")
        time.sleep(1)
        pupils[1].screenshot(options.folder / "reloaded.png")
        front.evaluate("document.querySelector('#freeze').click()")
        time.sleep(2)
        pupils[2].screenshot(options.folder / "frozen.png")
        front.screenshot(options.folder / "class-frozen.png")
        front.evaluate("document.querySelector('#freeze').click()")
        front.evaluate("document.querySelector('.pupil .open').click()")
        time.sleep(2)
        front.screenshot(options.folder / "large.png")
        outside.screenshot(options.folder / "no-room.png")
        front.navigate(f"{base}links")
        front.screenshot(options.folder / "links.png")
    finally:
        browser.close()
        background.close()
        server.send_signal(signal.SIGTERM)
        print(server.communicate(timeout=30)[0], end="")


if __name__ == "__main__":
    main()
