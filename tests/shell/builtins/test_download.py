"""wget and curl, against a server of this machine."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from select import select
from typing import Any

import pytest

from tests.support.waiting import until

TEXT = "import rclpy\nprint('你好')\n"


class Handler(BaseHTTPRequestHandler):
    """Has one file, and a way to it."""

    def do_GET(self) -> None:
        if self.path == "/moved":
            self.send_response(302)
            self.send_header("Location", "/examples/talker.py")
            self.end_headers()
            return
        self.send_response(200 if self.path == "/examples/talker.py" else 404)
        self.end_headers()
        self.wfile.write(TEXT.encode() if self.path == "/examples/talker.py" else b"nothing here\n")

    def log_message(self, *args: Any) -> None:
        """Say nothing."""


@pytest.fixture
def server(monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    monkeypatch.setenv("no_proxy", "127.0.0.1")
    made = HTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=made.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{made.server_port}"
    made.shutdown()
    made.server_close()


def test_wget_saves_a_file_by_its_name_and_says_so(machine: Any, server: str) -> None:
    done = machine.run(f"wget {server}/examples/talker.py; cat talker.py; ls")
    assert done.out == f"{TEXT}ros2_ws\ntalker.py\n"
    assert f"‘talker.py’ saved [{len(TEXT.encode())}]" in done.err and "200 OK" in done.err
    quiet = machine.run(
        f"mkdir src; wget -q -O src/mine.py {server}/moved; cat src/mine.py; wget -qP src {server}/examples/talker.py; ls src"
    )
    assert (quiet.out, quiet.err) == (f"{TEXT}mine.py\ntalker.py\n", "")


def test_what_is_not_there_is_told_and_leaves_no_file(machine: Any, server: str) -> None:
    missing = machine.run(f"wget {server}/nothing.py")
    assert missing.status == 8 and "ERROR 404: Not Found." in missing.err
    assert machine.run("wget").status == 1
    assert machine.run("wget file:///etc/passwd; curl file:///etc/passwd").out == ""
    one_of_two = machine.run(f"wget -q gopher://a.b/c {server}/examples/talker.py; echo $?; ls; rm talker.py")
    assert one_of_two.out == "1\nros2_ws\ntalker.py\n"
    assert machine.run("ls").out == "ros2_ws\n"
    failed = machine.run(f"curl -f {server}/nothing.py")
    assert (failed.status, failed.out) == (22, "")
    assert failed.err == "curl: (22) The requested URL returned error: 404\n"


def test_curl_prints_or_saves(machine: Any, server: str) -> None:
    assert machine.run(f"curl -sSL {server}/moved | head -1").out == "import rclpy\n"
    assert machine.run(f"curl -s {server}/nothing").out == "nothing here\n"
    assert (
        machine.run(
            f"curl -sO {server}/examples/talker.py; curl -s {server}/moved -o b.py; cmp=$(diff talker.py b.py); echo $?"
        ).out
        == "0\n"
    )


def test_a_server_that_does_not_answer_is_told(machine: Any) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
        refused = machine.run(f"curl http://127.0.0.1:{port}/")
    assert refused.status == 7 and refused.err.startswith("curl: (7) Failed to connect to 127.0.0.1")


def test_ctrl_c_gives_up_waiting(machine: Any) -> None:
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        program = machine.start(f"wget http://127.0.0.1:{silent.getsockname()[1]}/x")
        until(lambda: select([silent], [], [], 0)[0], meanwhile=lambda: machine.go(1.0))  # it has asked
        assert program.status is None
        program.interrupt()
        machine.wait(lambda: program.status is not None)
        assert program.status == 130
