"""Machines that are apart: network namespaces with a cable between them. Needs root and iproute2."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.link.link_harness import ProcessPeer
from tests.support.waiting import until

pytestmark = pytest.mark.process
TEACHER, PUPIL = "10.66.13.1", "10.66.13.2"
PORT = 7447


def ip(*words: str) -> None:
    subprocess.run(["ip", *words], check=True, capture_output=True)


class Hosts:
    """Two namespaces `a` and `b`; `cable(False)` pulls the cable."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._peers: list[ProcessPeer] = []
        self.names = {side: f"d6{side}{os.getpid()}" for side in "ab"}
        for name in self.names.values():
            ip("netns", "add", name)
        ends = {side: f"d{side}{os.getpid()}" for side in "ab"}
        ip("link", "add", ends["a"], "type", "veth", "peer", "name", ends["b"])
        for side, address in (("a", TEACHER), ("b", PUPIL)):
            ip("link", "set", ends[side], "netns", self.names[side])
            ip("-n", self.names[side], "addr", "add", f"{address}/24", "dev", ends[side])
            ip("-n", self.names[side], "link", "set", "lo", "up")
            ip("-n", self.names[side], "link", "set", ends[side], "up")
        self._end = ends["b"]

    def cable(self, is_in: bool) -> None:
        ip("-n", self.names["b"], "link", "set", self._end, "up" if is_in else "down")

    def peer(self, side: str, part: str = "", **addresses: str) -> ProcessPeer:
        runtime = self._folder / f"{side}{len(self._peers)}"
        environment = {
            "DAY6_RUNTIME_DIR": str(runtime),
            "DAY6_LINK": "on",
            "TEST_ADDRESSES": json.dumps(addresses),
            "TEST_PART": part,
        }
        stderr = self._folder / "stderr"
        stderr.touch()
        self._peers.append(ProcessPeer(environment, stderr, ["ip", "netns", "exec", self.names[side]]))
        return self._peers[-1]

    def close(self) -> None:
        for each in self._peers:
            if each.process.poll() is None:
                each.kill()
        for name in self.names.values():
            subprocess.run(["ip", "netns", "delete", name], capture_output=True)


@pytest.fixture
def hosts(short_folder: Path) -> Iterator[Hosts]:
    if sys.platform != "linux" or os.geteuid() != 0 or shutil.which("ip") is None:
        pytest.skip("network namespaces need Linux, root and iproute2")
    try:
        made = Hosts(short_folder)
    except subprocess.CalledProcessError as error:
        pytest.skip(f"no network namespaces here: {error.stderr.decode().strip()}")
    yield made
    made.close()


def test_a_class_over_a_cable_that_is_pulled(hosts: Hosts) -> None:
    teacher = hosts.peer("a", "teacher", listen=f"tcp/{TEACHER}:{PORT}")
    pupils = [hosts.peer("b", f"pupil {name}", connect=f"tcp/{TEACHER}:{PORT}") for name in ("anna", "ben")]
    for pupil in pupils:
        pupil.node("turtlesim")
    both = ["/anna/turtlesim", "/ben/turtlesim"]
    assert until(lambda: teacher.nodes() == both)
    hosts.cable(False)
    assert until(lambda: teacher.nodes() == [])
    assert all(pupil.nodes() == ["/turtlesim"] for pupil in pupils)
    hosts.cable(True)
    assert until(lambda: teacher.nodes() == both)


def test_routers_of_two_hosts_join_two_graphs(hosts: Hosts) -> None:
    one = hosts.peer("a", listen=f"tcp/{TEACHER}:{PORT}")
    other = hosts.peer("b", connect=f"tcp/{TEACHER}:{PORT}")
    one.node("talker")
    other.node("listener")
    assert until(lambda: one.nodes() == other.nodes() == ["/listener", "/talker"])
