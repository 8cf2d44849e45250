"""Writes plain values as YAML in the way ROS tools print messages: Unicode as it is, no line folded, order kept."""

from __future__ import annotations

import sys
from collections import OrderedDict
from functools import cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import yaml


def dump(value: Any, *, flow_style: bool = False) -> str:
    """Return the YAML text of dicts, lists and scalars, with a newline at its end.

    With `flow_style` sequences stand on one line; mappings outside of sequences stay in block style, as in the real tools.
    """
    import yaml

    return str(yaml.dump(value, Dumper=_dumper(), allow_unicode=True, width=sys.maxsize, default_flow_style=flow_style))


@cache
def _dumper() -> type[yaml.SafeDumper]:
    """A dumper of our own, because registering for OrderedDict on PyYAML's would change it for the whole process."""
    import yaml

    class MessageDumper(yaml.SafeDumper):
        pass

    def represent_ordered(dumper: yaml.SafeDumper, data: OrderedDict[str, Any]) -> yaml.MappingNode:
        pairs = [(dumper.represent_data(key), dumper.represent_data(item)) for key, item in data.items()]
        return yaml.MappingNode("tag:yaml.org,2002:map", pairs)

    MessageDumper.add_representer(OrderedDict, represent_ordered)
    return MessageDumper
