"""Reading a small JSON file of ours, which by now may be anybody's."""

from __future__ import annotations

from pathlib import Path


def read_object(path: Path, largest: int) -> dict[str, object]:
    """Return the JSON object in a file of at most `largest` bytes.

    Raises:
        OSError: the file cannot be read.
        ValueError: it is larger, no UTF-8, no JSON, or no object.
    """
    with open(path, "rb") as file:
        text = file.read(largest + 1)
    if len(text) > largest:
        raise ValueError("too large")
    import json  # where there is no such file, the first frame does without

    try:
        found = json.loads(text)
    except RecursionError:
        raise ValueError("nested too deeply") from None
    if not isinstance(found, dict):
        raise ValueError("not an object")
    return found
