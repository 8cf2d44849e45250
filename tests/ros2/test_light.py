"""What a listing does not need it does not load: a whole `ros2 topic list` must start quickly."""

from __future__ import annotations

import sys

import pytest

from tests.support.waiting import run

SCRIPT = """
import sys
from day6_core.ros.environment import activate
activate()
from day6_core.graph import Graph
from day6_core.ros import ros2
from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
scheduler = Scheduler(WorldClock(wall=None))
program = Program(Session(scheduler, Graph(), ["ros2", "topic", "list"]), ros2.main)
for _ in range(20):
    scheduler.advance(0.1)
assert program.status == 0
heavy = {"numpy", "asyncio", "yaml", "textual", "rich", "zenoh", "xmlrpc"} & {name.partition(".")[0] for name in sys.modules}
verbs = [name for name in sys.modules if ".ros2.topic." in name]
print(sorted(heavy), verbs)
"""


@pytest.mark.process
def test_a_list_loads_no_heavy_library_and_no_other_verb():
    done = run([sys.executable, "-c", SCRIPT])
    assert done.stdout.strip() == "[] ['day6_core.ros.ros2.topic.list']"
