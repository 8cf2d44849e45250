"""The plugins of this family are named in rqt's catalogue as their plugin.xml names them."""

from __future__ import annotations

import pytest

from day6_core.ros.programs.rqt_gui.catalogue import plugins
from day6_core.ros.programs.rqt_gui.plugin import plugin_of

NAMES = {
    "rqt_service_caller/ServiceCaller": ("Services", "Service Caller"),
    "rqt_publisher/Publisher": ("Topics", "Message Publisher"),
    "rqt_msg/Messages": ("Topics", "Message Type Browser"),
    "rqt_srv/Services": ("Services", "Service Type Browser"),
    "rqt_action/ActionPlugin": ("Actions", "Action Type Browser"),
}


@pytest.mark.parametrize("name", NAMES)
def test_a_plugin_is_in_the_menu_and_its_class_is_there(name: str) -> None:
    entry = next(entry for entry in plugins() if entry.name == name)
    assert (entry.group, entry.title) == NAMES[name]
    assert plugin_of(entry.package).title == entry.title
