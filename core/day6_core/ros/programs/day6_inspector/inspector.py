"""`ros2 run day6_inspector inspector`: shows what is wrong now, in a window or, without a screen, once as text."""

from __future__ import annotations

from functools import partial

from day6_core.graph.names import OBSERVER_PREFIX
from day6_core.link import state_of
from day6_core.ros.programs.day6_inspector.asking import Asking
from day6_core.ros.programs.day6_inspector.files import look
from day6_core.ros.programs.day6_inspector.model import Inspector
from day6_core.ros.programs.day6_inspector.sight import said_of
from day6_core.ros.remark_texts import TEXTS
from day6_core.session.harmless import one_line
from day6_core.session.session import Session
from day6_core.session.threads import in_thread

LOOK_SECONDS = 0.5
SETTLE_SECONDS = 1.5
"""Without a window: how long to listen before the findings are printed."""


async def main(session: Session) -> int | None:
    """Watch until interrupted; without a display print the findings and end with 1 if there are errors."""
    node = session.create_node(f"{OBSERVER_PREFIX}_inspector_{session.pid}", start_parameter_services=False)
    graph = session.graph
    assert graph is not None  # a node is in it
    model = Inspector(
        node, session.clock, graph, lambda: state_of(graph), overview=session.overview, reports=Asking(graph)
    )
    session.defer(model.close)
    session.spawn(session.spin(node))
    if session.display is None:
        return await _tell(session, model)
    model.refresh()
    session.display.open("inspector", "Inspector", model)
    session.spawn(_look_at_files(session, model))
    async for tick in session.every(LOOK_SECONDS / 2):
        # In between only other processes' answers are news.
        model.judge() if tick % 2 else model.refresh()
    return 0


async def _look_at_files(session: Session, model: Inspector) -> None:
    """Look at the files twice a second, each time in a thread."""
    while True:
        await _look_once(model)
        await session.sleep(LOOK_SECONDS)


async def _look_once(model: Inspector) -> None:
    where = model.where()
    if where is not None:
        model.take_files(await in_thread(partial(look, where)))


async def _tell(session: Session, model: Inspector) -> int:
    for _ in range(3):
        await session.sleep(SETTLE_SECONDS / 3)
        await _look_once(model)
        model.refresh()
    model.count()
    if model.quiet:
        session.print(TEXTS[f"inspector.quiet.{model.quiet}"])
        return 0
    for finding in model.findings:
        session.print(f"{finding.level}: {one_line(finding.text)}")
        if finding.next:
            session.print(f"    {one_line(finding.next)}")
    if not model.findings:
        session.print(TEXTS["inspector.well"])
    for line in said_of(model.looked, model.unseen, lambda key, **values: TEXTS[key].format(**values)):
        session.print(one_line(line))
    return 1 if any(finding.level == "error" for finding in model.findings) else 0
