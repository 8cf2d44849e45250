"""Content filters of subscriptions."""

from __future__ import annotations

from typing import NamedTuple


class ContentFilterOptions(NamedTuple):
    """An expression over a message's fields, with `%0`, `%1` … for the expression parameters."""

    filter_expression: str
    expression_parameters: list[str]
