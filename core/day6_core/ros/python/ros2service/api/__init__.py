"""Services, asked of a node or of `ros2cli.node.strategy.NodeStrategy`."""

from __future__ import annotations

from typing import Any

from ros2cli.node.strategy import NodeStrategy
from rosidl_runtime_py import get_service_interfaces, message_to_yaml
from rosidl_runtime_py.utilities import get_service

from day6_core.ros.ros2.cli.node import services


def get_service_names_and_types(*, node: Any, include_hidden_services: bool = False) -> list[tuple[str, list[str]]]:
    """Return all services with their types."""
    return [(name, types) for name, types in services(node, hidden=include_hidden_services)]


def get_service_names(*, node: Any, include_hidden_services: bool = False) -> list[str]:
    """Return the names of all services."""
    return [name for name, _ in services(node, hidden=include_hidden_services)]


def get_service_class(node: Any, service_name: str, include_hidden_services: bool) -> Any:
    """Return the class of a service, None if it isn't there. Raises RuntimeError for several types or a bad one."""
    types = dict(services(node, hidden=include_hidden_services)).get(service_name)
    if types is None:
        return None
    if len(types) > 1:
        raise RuntimeError(
            f"Cannot echo service '{service_name}', as it contains more than one type: [{', '.join(types)}]"
        )
    try:
        return get_service(types[0])
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The service type '{types[0]}' is invalid") from None


def service_type_completer(**kwargs: Any) -> list[str]:
    """Complete the type of a service."""
    return [f"{package}/{name}" for package, names in get_service_interfaces().items() for name in names]


class ServiceNameCompleter:
    """Completes the name of a service."""

    def __init__(self, *, include_hidden_services_key: str | None = None) -> None:
        self.include_hidden_services_key = include_hidden_services_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        hidden = bool(getattr(parsed_args, self.include_hidden_services_key or "", False))
        with NodeStrategy(parsed_args) as node:
            return get_service_names(node=node, include_hidden_services=hidden)


class ServiceTypeCompleter:
    """Completes the type of a service: of the one that was named, else every type."""

    def __init__(self, *, service_name_key: str | None = None) -> None:
        self.service_name_key = service_name_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        if self.service_name_key is None:
            return service_type_completer()
        with NodeStrategy(parsed_args) as node:
            return dict(get_service_names_and_types(node=node, include_hidden_services=True)).get(
                getattr(parsed_args, self.service_name_key), []
            )


class ServicePrototypeCompleter:
    """Completes a request with its default values."""

    def __init__(self, *, service_type_key: str | None = None) -> None:
        self.service_type_key = service_type_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        return [message_to_yaml(get_service(getattr(parsed_args, self.service_type_key or "")).Request())]
