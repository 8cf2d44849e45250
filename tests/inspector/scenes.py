"""What is played on whole machines and recorded there: the drills, the healthy scenes, the tutorials."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from tests.inspector.drills import DRILLS
from tests.inspector.faults_in_messages import IN_MESSAGES
from tests.inspector.inner_drills import INNER_DRILLS
from tests.inspector.test_healthy import SCENES
from tests.inspector.tutorials import TUTORIALS

if TYPE_CHECKING:
    from tests.inspector.lab import Lab


INJECTED = (*DRILLS, *IN_MESSAGES, *INNER_DRILLS)
"""Every fault."""


class Scene(NamedTuple):
    """One of them."""

    name: str
    happens: Callable[[Lab], object]
    findings: tuple[str, ...] = ()
    """Of a drill: one of them has to come, by its id. Elsewhere nothing is to be warned of."""


def _id(key: str) -> str:
    return key if key.startswith("world.") else f"inspector.{key}"


ALL = (
    *(Scene(f"drill {drill.number}", drill.inject, tuple(map(_id, drill.findings))) for drill in INJECTED),
    *(Scene(f"healthy {scene.__name__}", scene) for scene in SCENES),
    *(Scene(f"tutorial {tutorial.__name__}", tutorial) for tutorial in TUTORIALS),
)
