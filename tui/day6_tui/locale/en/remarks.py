"""The programs' remarks, which stand with the programs: they print them without a screen too."""

from day6_core.ros.remark_texts import TEXTS

__all__ = ["TEXTS"]
