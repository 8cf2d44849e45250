"""async_param_client: sets, lists, gets, loads and deletes parameters of the node parameter_blackboard."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ament_index_python import get_package_share_directory

from day6_core.ros.programs._component import ready
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient

if TYPE_CHECKING:
    from day6_core.session.session import Session

NAMES = ["int_parameter", "bool_parameter", "string_parameter"]
DELETED = ["other_int_parameter", "other_string_parameter", "string_parameter"]
MISSING = (
    "parameter_blackboard is not available, start parameter blackboard with "
    "`ros2 run demo_nodes_cpp parameter_blackboard` before running this demo"
)


async def main(session: Session) -> int:
    node = session.create_node("async_param_client")
    client = AsyncParameterClient(node, "parameter_blackboard")
    session.executor.add_node(node)
    info = node.get_logger().info

    async def answer(future: Any) -> Any:
        await session.spin_until(future)
        return future.result()

    try:
        if not await ready(session, client.services_are_ready, 3.0):
            raise RuntimeError(MISSING)
        info("Setting parameters:")
        values: list[Parameter[Any]] = [
            Parameter(NAMES[0], Parameter.Type.INTEGER, 10),
            Parameter(NAMES[1], Parameter.Type.BOOL, False),
            Parameter(NAMES[2], Parameter.Type.STRING, "Fee Fi Fo Fum"),
        ]
        for name, result in zip(NAMES, (await answer(client.set_parameters(values))).results, strict=True):
            info(f"    {name}:")
            info(f"        successful: {result.successful}")
        info("Listing Parameters:")
        for name in (await answer(client.list_parameters(NAMES, 10))).result.names:
            info(f"    - {name}")
        info("Getting parameters:")
        for name, value in zip(NAMES, (await answer(client.get_parameters(NAMES))).values, strict=True):
            info(f"    - {name}: {parameter_value_to_python(value)}")
        info("Loading parameters: ")
        file = str(Path(get_package_share_directory("demo_nodes_py"), "params.yaml"))
        loaded = parameter_dict_from_yaml_file(file, use_wildcard=True)
        results = (await answer(client.load_parameter_file(file, use_wildcard=True))).results
        for (name, parameter), result in zip(loaded.items(), results, strict=True):
            info(f"    {name}:")
            info(f"        successful: {result.successful}")
            info(f"        value: {parameter_value_to_python(parameter.value)}")
        info("Deleting parameters: ")
        for name, result in zip(DELETED, (await answer(client.delete_parameters(DELETED))).results, strict=True):
            info(f"    {name}:")
            info(f"        successful: {result.successful}")
            info(f"        reason: {result.reason}")
    except KeyboardInterrupt:
        return 0
    return 0
