"""What the suite's participants are made with: `World`, `ProcessPeer`."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from tests.link.link_peer import Peer
from tests.support.stacks import stacks
from tests.support.waiting import until

LEASE = "transport/link/tx/lease"
HOUR = "3600000"
HOUR_OF_LEASE = f'from day6_core.link import config\nconfig._COMMON["{LEASE}"] = "{HOUR}"\n'
"""Begins a program that Zenoh misses after an hour without a sign of life; see the fixture `hour_of_lease`."""

HERE = Path(__file__).parent
ROOT = HERE.parents[1]


class ProcessPeer:
    """A peer in a process of its own; every method of `Peer` works, by JSON lines."""

    def __init__(self, environment: dict[str, str], stderr: Path, before: Sequence[str] = ()) -> None:
        self._stderr = stderr
        self.process = subprocess.Popen(
            [*before, sys.executable, str(HERE / "link_peer.py")],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=stderr.open("ab"),
            text=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), **environment},
        )
        self.hello = self._answer()

    def __getattr__(self, name: str) -> Callable[..., Any]:
        def call(*positional: Any, **named: Any) -> Any:
            assert self.process.stdin is not None
            self.process.stdin.write(json.dumps([name, positional, named]) + "\n")
            self.process.stdin.flush()
            return self._answer()

        return call

    def _answer(self) -> Any:
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        assert line, f"the peer ended: {self._stderr.read_text()}"
        return json.loads(line)

    def kill(self) -> None:
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def end(self) -> int:
        """Let it come to its end by itself."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        until(lambda: self.process.poll() is not None)
        return int(self.process.returncode)


class World:
    """Makes peers that share one meeting place."""

    def __init__(self, folder: Path, runtime: Path) -> None:
        self.folder = folder
        self.runtime = runtime
        self.stderr = folder / "stderr"
        self.stderr.touch()
        self._processes: list[ProcessPeer] = []
        self._graphs: list[Any] = []

    def process(self, **environment: str) -> Any:
        settings = {"DAY6_RUNTIME_DIR": str(self.runtime), "DAY6_LINK": os.environ["DAY6_LINK"], **environment}
        peer = ProcessPeer(settings, self.stderr)
        self._processes.append(peer)
        return peer

    def here(self, *, joined: bool = True, domain_id: int = 0, **arguments: Any) -> Peer:
        from day6_core.graph import Graph
        from day6_core.link import join

        graph = Graph(domain_id)
        if joined:
            self._graphs.append(graph)
            link = join(graph, **arguments)
            assert link.problem is None
        return Peer(graph)

    def knowledge(self) -> str:
        """Return what each participant knows at this moment, for a test that has failed."""
        from day6_core.link import state_of

        said = [f"this process: {Peer(graph).knowledge()}, {state_of(graph)}" for graph in self._graphs]
        said += [f"process {peer.process.pid}: {_knowledge_of(peer)}" for peer in self._processes]
        return "\n".join([*said, *stacks()])

    def close(self) -> None:
        from day6_core.link import leave

        for graph in self._graphs:
            leave(graph)
        for peer in self._processes:
            if peer.process.poll() is None:
                peer.kill()


def _knowledge_of(peer: ProcessPeer) -> str:
    answers: list[str] = []

    def ask() -> None:
        with suppress(AssertionError, OSError):
            answers.append(peer.knowledge())

    asking = threading.Thread(target=ask, daemon=True)
    asking.start()
    asking.join(timeout=5.0)
    return answers[0] if answers else f"no answer, status {peer.process.poll()}"
