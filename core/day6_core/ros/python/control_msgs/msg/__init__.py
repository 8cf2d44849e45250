"""Message classes of control_msgs, each made when first used."""

from day6_core.interfaces.package import lazy_interfaces

__getattr__, __dir__ = lazy_interfaces(__name__)
