"""What a person sees of the doors to other machines: top line, inspector, `ros2 doctor`, in both languages, at 80x24."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from tests.e2e.place import Place
from tests.support.free_port import free_port
from tests.support.waiting import until

pytestmark = pytest.mark.person

SECRET = "chalk-and-sponge"
F6 = "\x1b[17~"


@pytest.fixture
def port() -> int:
    return free_port()


OPEN = {
    "en": ("open {port}: 0", "anyone who reaches port {port} can read and control", "there is no secret: anyone who"),
    "zh": ("开放 {port}：0 台", "能连到端口 {port} 的人都能读取数据、发送命令", "没有口令"),
}


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_an_open_door_says_who_can_come_in(place: Place, port: int, lang: str) -> None:
    top, notice, finding = (text.format(port=port) for text in OPEN[lang])
    with place.desktop("--listen", f"tcp/127.0.0.1:{port}", "--scene", "empty", lang=lang) as screen:
        screen.wait(notice)
        screen.wait(top)
        screen.press(F6)
        screen.wait(finding)


IN_USE = {
    "en": ("port {port} in use", "another program is using this port"),
    "zh": ("端口 {port} 被占用", "这个端口被别的程序占用"),
}


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_taken_port_is_told_and_programs_still_meet(place: Place, lang: str) -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        top, finding = (text.format(port=port) for text in IN_USE[lang])
        with place.desktop("--listen", f"tcp/127.0.0.1:{port}", "--scene", "empty", lang=lang) as screen:
            screen.wait(top)
            error = f"ERROR: tcp/127.0.0.1:{port}: another program is using this port"
            done = until(lambda: error in (done := place.run("ros2", "doctor")).stderr and done)
            assert done.returncode == 0 and "check(s) failed" in done.stdout
            screen.line("ros2 run turtlesim turtlesim_node &")
            screen.wait("TurtleSim")
            until(lambda: "/turtlesim" in place.nodes())
            screen.press(F6)
            screen.wait(" 3 ")
            screen.press("Alt-3", "F8")
            screen.wait(finding)


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_who_has_another_secret_is_told_that_he_is_refused(place: Place, port: int, tmp_path: Path, lang: str) -> None:
    secret = tmp_path / "secret"
    secret.write_text(SECRET, encoding="utf-8")
    secret.chmod(0o600)
    words = {"en": ("refused by 127.0.0.1", "wrong secret"), "zh": ("127.0.0.1 拒绝加入", "口令不对")}[lang]
    code = (
        "import sys, time; from day6_core.graph import Graph; from day6_core.link import join; "
        f"join(Graph(), listen='tcp/127.0.0.1:{port}', secret='{SECRET}'); print('open', flush=True); sys.stdin.read()"
    )
    environment = {**os.environ, "DAY6_RUNTIME_DIR": str(tmp_path / "teacher"), "DAY6_LINK": "on"}
    with subprocess.Popen(
        [sys.executable, "-c", code], env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as teacher:
        try:
            assert teacher.stdout is not None and teacher.stdout.readline() == "open\n"
            arguments = ("--connect", f"tcp/127.0.0.1:{port}", "--scene", "empty", "--secret")
            with place.desktop(*arguments, "sponge-and-chalk", lang=lang) as screen:
                screen.wait(words[0])
                screen.press(F6)
                screen.wait(words[1])
            with place.desktop(*arguments, str(secret), lang=lang) as screen:
                screen.wait({"en": "joined 127.0.0.1", "zh": "已加入 127.0.0.1"}[lang])
        finally:
            teacher.kill()


def test_a_desktop_with_an_open_door_ends_at_sigterm_while_strangers_flood_it(place: Place, port: int) -> None:
    flood = Path(__file__).parents[1] / "link" / "hostile_peer.py"
    with place.desktop("--listen", f"tcp/127.0.0.1:{port}", "--scene", "empty", lang="en") as screen:
        screen.wait(f"open {port}: 0")
        with subprocess.Popen(
            [sys.executable, str(flood), str(port)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        ) as hostile:
            try:
                assert hostile.stdout is not None and hostile.stdin is not None
                assert hostile.stdout.readline() == "ready\n"
                hostile.stdin.write('["tokens", ["@ros2_lv/0/ffffffffffffffff/{}/{}/NN/%/%/flood{}", 5000], {}]\n')
                hostile.stdin.flush()
                assert hostile.stdout.readline() == "5000\n"
                screen.wait("nodes 500")
                os.kill(screen.pid, signal.SIGTERM)
                screen.wait_end()
            finally:
                hostile.kill()
