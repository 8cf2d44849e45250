"""The check and the report of topics of `ros2 doctor`."""

from ros2doctor.api import own_check, own_report

SKIP_TOPICS = ["/parameter_events", "/rosout"]
TopicCheck = own_check("topic")
TopicReport = own_report("TOPIC LIST")
