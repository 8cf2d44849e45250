"""A real kernel, with the messages a notebook gets."""

from __future__ import annotations

import os
import queue
import re
import sys
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

from jupyter_client import manager

from tests.support.waiting import PATIENCE, Deadline, until


class Kernel:
    """Runs cells and gathers what is shown below each, by the messages a notebook gets."""

    def __init__(self, runtime: Path) -> None:
        environment = {**os.environ, "DAY6_RUNTIME_DIR": str(runtime), "DAY6_LINK": "on", "DAY6_LANG": "en"}
        environment.pop("PYTHONPATH", None)
        self.manager = manager.KernelManager()
        self.manager.kernel_spec.argv[0] = sys.executable
        self.manager.start_kernel(env=environment)
        self.client: Any = self.manager.client()
        self.client.start_channels()
        deadline = Deadline()
        while True:
            try:
                self.client.wait_for_ready(timeout=PATIENCE / 10)
                break
            except RuntimeError:
                assert self.manager.is_alive() and not deadline.is_over(), "the kernel does not answer"
        self.shown: dict[str, str] = defaultdict(str)
        """By cell, without colours."""
        self.troubles = ""
        """What cells wrote on stderr, which a notebook shows in red."""
        self._idle: set[str] = set()

    def start(self, code: str) -> str:
        """Send a cell; what tells it apart from other cells."""
        return str(self.client.execute(code))

    def run(self, code: str, *, interrupt_after: str = "") -> str:
        """Run a cell; what is shown below it when it ends. With `interrupt_after` it is interrupted when that is shown."""
        cell = self.start(code)
        if interrupt_after:
            self.wait(lambda: interrupt_after in self.shown[cell], cell)
            self.manager.interrupt_kernel()
        self.wait(lambda: cell in self._idle, cell)
        return self.shown[cell]

    def wait(self, condition: Callable[[], bool], cell: str) -> None:
        """Take messages until it is true."""
        deadline = Deadline()
        while not condition():
            assert not deadline.is_over(), self.shown[cell]
            try:
                self._take(self.client.get_iopub_msg(timeout=0.2))
            except queue.Empty:
                continue

    def _take(self, message: dict[str, Any]) -> None:
        kind, content, cell = message["msg_type"], message["content"], message["parent_header"].get("msg_id", "")
        if kind == "stream":
            text = _plain(content["text"])
            self.shown[cell] += text
            self.troubles += text if content["name"] == "stderr" else ""
        elif kind == "execute_result":
            self.shown[cell] += f"{content['data']['text/plain']}\n"
        elif kind == "error":
            self.shown[cell] += _plain("\n".join(content["traceback"]))
        elif kind == "status" and content["execution_state"] == "idle":
            self._idle.add(cell)

    def until(self, expression: str) -> None:
        """Run cells until this is true: what happens in between happens without a cell."""
        until(lambda: "True" in self.run(f"print(bool({expression}))"), every=0.1, told=lambda: expression)

    def close(self) -> None:
        self.client.stop_channels()
        self.manager.shutdown_kernel(now=True)


def _plain(text: str) -> str:
    """The text without colours."""
    return re.sub(r"\x1b\[[\d;]*m", "", text)
