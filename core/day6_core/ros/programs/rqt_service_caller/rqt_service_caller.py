"""`ros2 run rqt_service_caller rqt_service_caller`: fills in a request, calls the service and shows its response."""

from __future__ import annotations

from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_service_caller.model import ServiceCaller
from day6_core.session.session import Session

STEP_SECONDS = 0.25
"""How often the time of waiting is looked at."""

REFRESH_SECONDS = 0.05
"""At most this often is the graph looked at again, or a request of the window carried out."""


class ServiceCallerPlugin(Plugin[ServiceCaller]):
    """rqt_service_caller/ServiceCaller."""

    kind, title = "service_caller", "Service Caller"

    def __init__(self, place: PluginPlace) -> None:
        wanted = place.settings.get("current_service_name")
        clock = place.session.clock
        super().__init__(place, ServiceCaller(place.node, clock.steady_ns, wanted if isinstance(wanted, str) else ""))
        self.model.on_request = place.wake
        self.model.on_warning = place.session.print_error

    async def run(self) -> None:
        self.model.follow()
        self.place.spawn(self.place.repeat(self.model.tick, STEP_SECONDS, lambda: self.model.is_waiting))
        await self.place.follow(self.model.follow, REFRESH_SECONDS)

    def close(self) -> None:
        self.model.close()

    def settings(self) -> Settings:
        return {"current_service_name": self.model.service}


async def main(session: Session) -> int | None:
    """Open the window and call services until it is closed."""
    return await run_alone(session, ServiceCallerPlugin)
