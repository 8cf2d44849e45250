"""Message classes of type_description_interfaces, each made when first used."""

from day6_core.interfaces.package import lazy_interfaces

__getattr__, __dir__ = lazy_interfaces(__name__)
