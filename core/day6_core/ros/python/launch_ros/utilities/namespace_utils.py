"""Combines namespaces."""

from __future__ import annotations


def is_root_namespace(ns: str) -> bool:
    """Return whether it is `/`."""
    return ns == "/"


def is_namespace_absolute(ns: str) -> bool:
    """Return whether it begins with `/`."""
    return ns.startswith("/")


def prefix_namespace(base_ns: str | None, ns: str | None) -> str | None:
    """Return `ns` relative to `base_ns`; an absolute one is returned unchanged, None means there is none."""
    if ns is None or base_ns is None:
        combined = base_ns if ns is None else ns
    elif not base_ns or is_namespace_absolute(ns):
        combined = ns
    else:
        combined = f"{'' if is_root_namespace(base_ns) else base_ns}/{ns}"
    if combined is None or is_root_namespace(combined):
        return combined
    return combined.rstrip("/")


def make_namespace_absolute(ns: str | None) -> str | None:
    """Return it with a leading `/`; None for None."""
    return ns if ns is None or is_namespace_absolute(ns) else f"/{ns}"
