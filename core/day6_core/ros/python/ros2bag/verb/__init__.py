"""What a verb of `ros2 bag` is derived from; the verbs themselves are modules made at their import (see `ros2cli`)."""

from __future__ import annotations

from ros2cli.verb import VerbExtension as _VerbExtension


class VerbExtension(_VerbExtension):
    """A verb of `ros2 bag`."""
