"""The graph that rqt_graph is tried with: something for each of its switches to show or hide."""

from __future__ import annotations

from day6_core.ros.programs.rqt_graph.model.content import Content, GraphContent

ACTION = "/turtle1/rotate_absolute/_action/"
FACTS = GraphContent(
    publishers={
        "/turtle1/cmd_vel": ("/teleop_turtle",),
        "/turtle1/pose": ("/turtlesim",),
        ACTION + "feedback": ("/turtlesim",),
        ACTION + "status": ("/turtlesim",),
        "/rosout": ("/turtlesim", "/teleop_turtle", "/_ros2cli_1"),
        "/parameter_events": ("/turtlesim", "/teleop_turtle"),
        "/tf": ("/robot_state_publisher",),
        "/tf_static": ("/robot_state_publisher",),
        "/joint_states": ("/wheel_spinner",),
        "/cam/image": ("/cam/driver",),
        "/cam/image/compressed": ("/cam/driver",),
        "/cam/image/theora": ("/cam/driver",),
        **{f"/dock/{end}": ("/client",) for end in ("goal", "cancel")},
        **{f"/dock/{end}": ("/server",) for end in ("feedback", "status", "result")},
        "/clock": ("/sim",),
    },
    subscribers={
        "/turtle1/cmd_vel": ("/turtlesim", "/_ros2cli_1"),
        ACTION + "feedback": ("/teleop_turtle",),
        ACTION + "status": ("/teleop_turtle",),
        "/parameter_events": ("/turtlesim",),
        "/tf": ("/rviz2", "/listener"),
        "/tf_static": ("/rviz2",),
        "/joint_states": ("/robot_state_publisher",),
        "/cam/image": ("/viewer",),
        "/cam/image/compressed": ("/viewer",),
        "/nobody_sends": ("/viewer",),
        **{f"/dock/{end}": ("/server",) for end in ("goal", "cancel")},
        **{f"/dock/{end}": ("/client",) for end in ("feedback", "status", "result")},
        "/clock": ("/turtlesim",),
    },
)


def shown(content: Content) -> tuple[set[str], set[tuple[str, str, str]]]:
    """Return the names of the boxes and the edges (start, end, label) of a picture."""
    boxes = {box.lines[0] for box in content.boxes}
    return boxes, {(edge.start.strip(), edge.end.strip(), edge.label) for edge in content.edges}
