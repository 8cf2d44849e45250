"""A stepped machine with a plugin of rqt and the nodes of other programs, which can be ended or held."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from day6_core.session.program import Program
from day6_core.session.session import Session
from tests.support.stepped_machine import Running, SteppedMachine


class OtherProgram:
    """A program that has one node and spins it, if it `spins`."""

    def __init__(self, machine: SteppedMachine, name: str, *, spins: bool = True, **keywords: Any) -> None:
        self._machine = machine
        self.session = Session(machine.scheduler, machine.graph, [name])
        self.node = self.session.create_node(name, **keywords)
        self._program = Program(self.session, self._main) if spins else None

    async def _main(self, session: Session) -> None:
        await session.spin(self.node)

    def hold(self) -> None:
        """Answer nothing any more, as a program that was stopped."""
        self.session.stop()
        self._machine.advance()

    def end(self) -> None:
        """End; its node is gone."""
        if self._program is not None:
            self._program.kill()
        self.session.close()
        self._machine.advance(0.3)


class RqtMachine(SteppedMachine):
    """Runs one plugin with a screen; its node is `own`."""

    own = ""

    def __init__(self, package: str, folder: Path) -> None:
        super().__init__()
        self.folder = folder
        self._package = package
        self._others: list[OtherProgram] = []

    def other(self, name: str, **keywords: Any) -> OtherProgram:
        """Start another program."""
        found = OtherProgram(self, name, **keywords)
        self._others.append(found)
        self.advance()
        return found

    def open(self, *words: str, seconds: float = 0.5) -> Running:
        """Start the plugin."""
        running = self.start(self._package, self._package, *words, screen=True, home=self.folder)
        self.advance(seconds)
        self.own = next(name for name in self.node.get_fully_qualified_node_names() if "/rqt_gui_" in name)
        return running

    @property
    def model(self) -> Any:
        return self.display.windows[0].model

    def do(self, request: str, *given: Any, seconds: float = 0.2) -> None:
        """Make a request of the window, and let it come about."""
        getattr(self.model, request)(*given)
        self.advance(seconds)

    def end(self) -> None:
        for each in self._others:
            each.session.resume()
            each.end()
        super().end()
