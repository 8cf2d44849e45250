"""`ros2 run day6_kitchen kitchen`: the live graph as a kitchen, in a window or, without a screen, as text.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from day6_core.graph import Graph
from day6_core.link import listen_in
from day6_core.ros.programs._without_screen import stays
from day6_core.ros.programs.day6_inspector.asking import Asking
from day6_core.ros.programs.day6_kitchen.belts import Belt
from day6_core.ros.programs.day6_kitchen.model import Kitchen
from day6_core.session.session import Session

ASK_SECONDS = 1.0
"""Between two questions to other processes."""

SETTLE_SECONDS = 0.5
"""Without a window: how long to let the graph be discovered before it is printed."""


async def main(session: Session) -> int | None:
    """Show the kitchen until interrupted; without a display print it once, or stay."""
    graph = session.graph
    assert graph is not None
    name = f"_day6_kitchen_{session.pid}"
    node = session.create_node(name, start_parameter_services=False)
    if session.display is None and stays(session, node):
        await session.spin(node)
        return 0
    if session.display is None:
        await session.sleep(SETTLE_SECONDS)
        _print(session, graph, name)
        return 0
    command_of = session.overview.command_of if session.overview is not None else lambda pid: ()
    model = Kitchen(graph, name, lambda: listen_in(graph), command_of)
    session.defer(graph.add_listener(model.on_change))
    session.defer(model.close)
    session.display.open("kitchen", "Kitchen", model)
    session.spawn(_ask(session, model, Asking(graph)))
    await session.spin(node)
    return 0


async def _ask(session: Session, model: Kitchen, asking: Asking) -> None:
    """Let other processes tell what they publish, as long as one of them has nobody who takes it."""
    async for _ in session.every(ASK_SECONDS):
        if model.unheard:
            asking.hear()
            model.told = {
                (inside.node, topic): count
                for process in asking.processes
                for inside in process.nodes
                for topic, count in inside.publishers.items()
            }
            asking.ask()


def _print(session: Session, graph: Graph, name: str) -> None:
    model = Kitchen(graph, name)
    model.look(0.0)
    for cook in model.content.cooks:
        session.print(f"cook {cook.name}" + (f" ({cook.count} of this name)" if cook.count > 1 else ""))
    for belt in model.content.belts:
        session.print(f"belt {belt.topic} [{', '.join(belt.types)}]: {_ends(belt)}")
        for refusal in belt.refusals:
            session.print(
                f"  {refusal.taker.cook} gets nothing of {refusal.giver.cook}: {refusal.why} {refusal.detail}"
            )
    if not model.content.cooks:
        session.print("The kitchen is empty: there is no node.")


def _ends(belt: Belt) -> str:
    givers, takers = (
        [*dict.fromkeys(hand.cook for hand in hands), *([f"{unseen} hidden"] if unseen else [])]
        for hands, unseen in ((belt.givers, belt.unseen_givers), (belt.takers, belt.unseen_takers))
    )
    return f"{', '.join(givers) or 'nobody'} -> {', '.join(takers) or 'nobody'}"
