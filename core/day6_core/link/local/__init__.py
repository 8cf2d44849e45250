"""Our own engine: it carries messages between the processes of one user on one machine, over sockets, without Zenoh.

It offers what the link uses of Zenoh's Python API, under the same names (see `day6_core.link.engine`), and nothing more: no other
machines, no routing, keys without wildcards but in questions and liveliness. Every process is connected to every other one.
"""

from day6_core.link.local.place import Config
from day6_core.link.local.questions import Query
from day6_core.link.local.session import Session
from day6_core.link.local.vocabulary import (
    CancellationToken,
    CongestionControl,
    ConsolidationMode,
    Locality,
    Priority,
    QueryTarget,
    Reply,
    Sample,
    SampleKind,
    ZError,
    handlers,
)

__all__ = [
    "CancellationToken",
    "Config",
    "CongestionControl",
    "ConsolidationMode",
    "Locality",
    "Priority",
    "Query",
    "QueryTarget",
    "Reply",
    "Sample",
    "SampleKind",
    "Session",
    "ZError",
    "handlers",
]
