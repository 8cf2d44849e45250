"""`ros2 run rqt_action rqt_action`: browses the types of actions, and shows the actions of the graph with their goals."""

from __future__ import annotations

from day6_core.ros.programs.rqt_action.model import ActionBrowser
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, run_alone
from day6_core.session.session import Session

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again, or a request of the window carried out."""


class ActionPlugin(Plugin[ActionBrowser]):
    """rqt_action/ActionPlugin."""

    kind, title = "action_browser", "Action Type Browser"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(place, ActionBrowser(place.node))
        self.model.on_request = place.wake
        self.model.browser.on_warning = place.session.print_error

    async def run(self) -> None:
        self.model.follow()
        await self.place.follow(self.model.follow, REFRESH_SECONDS)

    def close(self) -> None:
        self.model.close()


async def main(session: Session) -> int | None:
    """Open the window until it is closed."""
    return await run_alone(session, ActionPlugin)
