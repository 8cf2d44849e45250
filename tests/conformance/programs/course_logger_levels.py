"""Levels of loggers and their children, and what is shown."""

import rclpy
from rclpy.logging import LoggingSeverity, get_logger, get_logger_effective_level, set_logger_level

rclpy.init()
node = rclpy.create_node("noisy")
log = node.get_logger()
print(log.debug("a debug"))
print(log.info("an info"))
print(log.warning("a warning"))
print(log.error("an error"))
print(log.fatal("a fatal"))
try:
    for method in (log.info, log.error):
        method("two levels from one line")
except ValueError as error:
    print("ValueError", error)
child = log.get_child("arm")
print(child.name, child.get_effective_level(), child.is_enabled_for(LoggingSeverity.DEBUG))
log.set_level(LoggingSeverity.ERROR)
print(child.get_effective_level(), child.warning("not shown"), child.error("shown"))
child.set_level(LoggingSeverity.DEBUG)
print(child.debug("shown too"), get_logger_effective_level("noisy"))
set_logger_level("other.logger", LoggingSeverity.WARN)
print(get_logger("other.logger.deep").get_effective_level(), get_logger("other").get_effective_level())
for i in range(3):
    log.error("only once", once=True)
for i in range(3):
    log.error(f"skipped first {i}", skip_first=True)
for i in range(3):
    log.error(f"throttled {i}", throttle_duration_sec=60)
try:
    log.info(5)
except TypeError as error:
    print("TypeError", error)
rclpy.shutdown()
