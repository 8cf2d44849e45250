"""Where the files that a robot's description names may be looked for: packages, and how far its sender is trusted."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.graph import EndpointKind
from day6_core.link.remote import lives_here

if TYPE_CHECKING:
    from day6_core.graph import Endpoint
    from day6_core.session.session import Session


def share_folders(session: Session) -> Callable[[str], str]:
    """Return what finds a package's share folder as this program's environment is now; for any thread.

    It raises LookupError for a package that isn't there.
    """
    from ament_index_python.packages import get_package_share_directory

    environment = dict(session.env)

    def share_of(package: str) -> str:
        try:
            return get_package_share_directory(package, False, environment)
        except ValueError as error:
            raise LookupError(str(error)) from None

    return share_of


def are_of_this_machine(session: Session, wanted: Callable[[Endpoint], bool]) -> bool:
    """Whether there are such publishers and each belongs to this process, or to another one of this user on this machine."""
    graph = session.graph
    if graph is None:
        return False
    found = [publisher for publisher in graph.endpoints(EndpointKind.PUBLISHER) if wanted(publisher)]
    return bool(found) and all(p.origin is None or lives_here(p.origin, graph.domain_id) for p in found)
