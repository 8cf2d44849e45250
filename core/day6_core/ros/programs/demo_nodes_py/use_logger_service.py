"""use_logger_service: one node sets the logger level of another one by its services, and shows what is logged then."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

from day6_core.ros.programs.demo_messages import String
from rclpy.task import Future

if TYPE_CHECKING:
    from day6_core.session.session import Session

REMOTE = "LoggerServiceNode"
LEVELS = {"debug": 10, "warn": 30, "error": 40}


async def main(session: Session) -> int:
    return await change_levels(session, 0.5)


async def change_levels(session: Session, pause: float) -> int:
    """Run the demo; `pause` is in seconds, the time for a message to be logged."""
    remote = session.create_node(REMOTE, enable_logger_service=True)
    remote.create_subscription(String, "output", lambda message: _log_at_all_levels(remote, message.data), 10)
    node = session.create_node("TestNode")
    publisher = node.create_publisher(String, "output", 10)
    getter = node.create_client(GetLoggerLevels, f"{REMOTE}/get_logger_levels")
    setter = node.create_client(SetLoggerLevels, f"{REMOTE}/set_logger_levels")
    for each in (remote, node):
        session.executor.add_node(each)
    logger = node.get_logger()

    async def say(text: str) -> None:
        publisher.publish(String(data=text))
        await session.spin_until(Future(), pause)

    async def answer(client: Any, request: Any) -> Any:
        future = client.call_async(request)
        await session.spin_until(future)
        return future.result()

    async def tell_level() -> None:
        found = await answer(getter, GetLoggerLevels.Request(names=[REMOTE]))
        logger.info(f"Current logger level: {found.levels[0].level}")

    try:
        logger.info("Output with default logger level:")
        await say("Output 1")
        await tell_level()
        for number, (name, level) in enumerate(LEVELS.items(), 2):
            logger.info(f"Output with {name} logger level:")
            request = SetLoggerLevels.Request(levels=[LoggerLevel(name=REMOTE, level=level)])
            result = (await answer(setter, request)).results[0]
            if result.successful:
                await say(f"Output {number}")
            else:
                logger.error(f"Failed to change logger level: {result.reason}")
                logger.error(f"Failed to set {name} logger level via logger service !")
            await tell_level()
    except KeyboardInterrupt:
        return 0
    return 0


def _log_at_all_levels(node: Any, text: str) -> None:
    logger = node.get_logger()
    logger.debug(f"{text} with DEBUG logger level.")
    logger.info(f"{text} with INFO logger level.")
    logger.warning(f"{text} with WARN logger level.")
    logger.error(f"{text} with ERROR logger level.")
