"""`ros2 run rqt_reconfigure rqt_reconfigure [NODE…]`: shows and changes the parameters of nodes.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

from day6_core.reason import reason
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_reconfigure.model import Reconfigure, read_values
from day6_core.session.argument_parser import SessionParser
from day6_core.session.session import Session
from day6_core.session.threads import in_thread

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again while it changes."""

DISCOVERY_SECONDS = 1.0
"""How long a node that is named on the command line may take to appear."""


class ReconfigurePlugin(Plugin[Reconfigure]):
    """rqt_reconfigure/Param."""

    kind, title = "rqt_reconfigure", "Parameter Reconfigure"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, Reconfigure(place.node, place.session.clock.steady_ns, place.session.path))
        self.model.on_load = lambda node, path: place.spawn(self._load(node, path))
        self._named: list[str] = place.option("node_name", [])
        kept = place.settings.get("selected_nodes")
        selected = [each for each in kept if isinstance(each, str)] if isinstance(kept, list) else []
        self._selected = self._named or selected
        text = place.settings.get("text")
        self.model.filter = text if isinstance(text, str) else ""

    @staticmethod
    def add_arguments(parser: SessionParser) -> None:
        group = parser.add_argument_group("Options for rqt_reconfigure plugin")
        group.add_argument("node_name", nargs="*", default=[], help="Node(s) to open automatically")

    async def run(self) -> None:
        self.place.serve(self.model)
        self.place.spawn(self.place.repeat(self.model.tick, 1.0, lambda: self.model.is_waiting))
        self.place.spawn(self._select())
        await self.place.follow(self.model.refresh, REFRESH_SECONDS)

    async def _select(self) -> None:
        """Open the nodes that were named, or were open when the perspective was kept; those that are not there are told."""
        session, model = self.place.session, self.model
        await session.until(lambda: set(self._selected) <= set(model.nodes), DISCOVERY_SECONDS)
        for name in self._selected:
            if name in model.nodes:
                model.open_node(name)
            elif self._named:
                message = f"Could not find a dynamic reconfigure client named '{name}'"  # param_widget.py
                self.place.node.get_logger().warning(message)

    async def _load(self, node: str, path: Path) -> None:
        try:
            self.model.take_values(node, await in_thread(partial(read_values, path)))
            self.model.tell(str(path))
        except (OSError, ValueError, TypeError) as error:
            # TypeError: what rclpy's Parameter says of a value that no parameter can have
            self.model.tell(f"Parameter loading wasn't successful because: {reason(error)}")

    def close(self) -> None:
        self.model.close()

    def settings(self) -> Settings:
        return {"selected_nodes": [each.name for each in self.model.opened], "text": self.model.filter}


async def main(session: Session) -> int | None:
    """Open the window and follow the opened nodes until interrupted."""
    return await run_alone(session, ReconfigurePlugin)
