"""The error for a condition that is neither true nor false."""

from __future__ import annotations

from collections.abc import Sequence

from launch.substitution import Substitution


class InvalidConditionExpressionError(ValueError):
    """Raised with the text, the substitutions it came from, and the valid texts."""

    def __init__(
        self, expression: str, unexpanded_expression: Sequence[Substitution], valid_expressions: Sequence[str]
    ) -> None:
        origin = " + ".join(map(str, unexpanded_expression))
        super().__init__(
            f"invalid condition expression, expected one of [{', '.join(valid_expressions)}] "
            f"but got '{expression}', expanded from '{origin}'"
        )
