"""Faults inside programs, each injected for real: callbacks, executors, threads, actions, synchronizers, parameters, launch.

`INNER_DRILLS` is a table like `drills.DRILLS`; its numbers begin with i.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from tests.inspector.drills import HEAD, NODE, Drill, program, spinning

if TYPE_CHECKING:
    from tests.inspector.lab import Lab

SPIN = "rclpy.spin(node)\n"
POOLED = """
from rclpy.executors import MultiThreadedExecutor
executor = MultiThreadedExecutor(4)
executor.add_node(node)
executor.spin()
"""
ACTION = """
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer, CancelResponse
"""
ASKS = """
client = ActionClient(node, Fibonacci, 'fibonacci')
client.send_goal_async(Fibonacci.Goal(order=3))
"""
SYNC = """
from message_filters import ApproximateTimeSynchronizer, Subscriber, TimeSynchronizer
from rclpy.qos import QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image, Imu, LaserScan

rclpy.init()
node = Node('mine')
images = node.create_publisher(Image, 'image', 10)
scans = node.create_publisher(LaserScan, 'scan', 10)

def sent(publisher, message, seconds_ago=0.0):
    at = node.get_clock().now().nanoseconds - int(seconds_ago * 1e9)
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(at, 10**9)
    publisher.publish(message)

def both(image, scan):
    print('both', flush=True)

inputs = [Subscriber(node, Image, 'image'), Subscriber(node, LaserScan, 'scan')]
"""
IMAGES = "node.create_timer(0.1, lambda: sent(images, Image()))\n"


def beside(other: str, text: str) -> Callable[[Lab], object]:
    """A program that is all right, and the one with the fault beside it."""

    def inject(lab: Lab) -> None:
        lab.file("other.py", HEAD + other)
        lab.start("python3 other.py", 1)
        lab.wait_node("/other")
        program(text)(lab)

    return inject


def background(lab: Lab) -> None:
    """A thread dies in a program that runs in the background, with its output in a file."""
    lab.file("program.py", HEAD + DYING_THREAD)
    lab.run("python3 program.py > log.txt 2>&1 &")
    lab.wait_node("/mine")


def canceled(text: str) -> Callable[[Lab], object]:
    """An action server that is asked to cancel its goal."""

    def inject(lab: Lab) -> None:
        program(ACTION + NODE + text)(lab)
        lab.file(
            "other.py",
            HEAD
            + ACTION
            + spinning(
                "client = ActionClient(node, Fibonacci, 'fibonacci')\n"
                "client.wait_for_server()\n"
                "goal = client.send_goal_async(Fibonacci.Goal(order=3))\n"
                "rclpy.spin_until_future_complete(node, goal)\n"
                "rclpy.spin_until_future_complete(node, goal.result().cancel_goal_async(), timeout_sec=1.0)\n"
                "print('asked to cancel', flush=True)\n",
                "other",
            ),
        )
        lab.start("python3 other.py", 1, shows="asked to cancel")

    return inject


def launched(node: str, shows: str = "") -> Callable[[Lab], object]:
    """A launch file with one node, written so, and the program that it starts."""

    def inject(lab: Lab) -> None:
        program_file = lab.file(
            "program.py",
            "#!/usr/bin/env python3\n"
            + HEAD
            + NODE
            + "node.declare_parameter('speed', '')\nprint('up', flush=True)\nrclpy.spin(node)\n",
        )
        program_file.chmod(0o755)
        lab.file(
            "my.launch.py",
            "from launch import LaunchDescription\n"
            "from launch.actions import DeclareLaunchArgument, ExecuteProcess\n"
            "from launch.substitutions import LaunchConfiguration\n"
            "from launch_ros.actions import Node\n\n"
            "def generate_launch_description():\n"
            "    speed = LaunchConfiguration('speed')\n"
            f"    program = {str(program_file)!r}\n"
            "    return LaunchDescription([\n"
            f"        DeclareLaunchArgument('speed', default_value='1.5'),\n        {node},\n    ])\n",
        )
        lab.start("ros2 launch my.launch.py", shows=shows)

    return inject


DYING_THREAD = "import threading\n" + spinning(
    "def work():\n    time.sleep(0.5)\n    {}['speed']\n"
    "threading.Thread(target=work).start()\nnode.create_timer(0.1, lambda: None)\n"
)
FAST = spinning(
    "publisher = node.create_publisher(String, 'chatter', 10)\nnode.create_timer(0.002, lambda: publisher.publish(String()))\n",
    "other",
)
SLOW = spinning(
    "publisher = node.create_publisher(String, 'chatter', 10)\nnode.create_timer(0.1, lambda: publisher.publish(String()))\n",
    "other",
)
SERVES = spinning("node.create_service(Trigger, 'trigger', lambda request, response: response)\n", "other")
HEARS = "def heard(message):\n{}\nnode.create_subscription(String, 'chatter', heard, 10)\n"
GROUPED = (
    """
rclpy.init()
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
node = Node('mine')
group = MutuallyExclusiveCallbackGroup()
client = node.create_client(Trigger, 'trigger', callback_group=group)

def tick():
    client.call(Trigger.Request())

node.create_timer(0.2, tick, callback_group=group)
"""
    + POOLED
)
SERVER = """def serve(request, response):
    return response

node.create_service(Trigger, 'trigger', serve, callback_group=group)

"""
GROUPED_SERVER = GROUPED.replace("def tick", SERVER + "def tick").replace(
    "create_client(Trigger, 'trigger', callback_group=group)", "create_client(Trigger, 'trigger')"
)
CLIENT = spinning("client = node.create_client(Trigger, 'trigger')\ndef tick():\n{}\nnode.create_timer(0.2, tick)\n")

INNER_DRILLS: tuple[Drill, ...] = (
    # -- exceptions ----------------------------------------------------------------------------------------------------
    Drill(
        "i1",
        "except: pass at every message",
        beside(SLOW, spinning(HEARS.format("    try:\n        print(message.text)\n    except:\n        pass"))),
        ("swallowed",),
    ),
    Drill(
        "i1b",
        "except Exception: return in a timer",
        program(
            "class Mine(Node):\n    def __init__(self):\n        super().__init__('mine')\n"
            "        self.create_timer(0.1, self.tick)\n\n    def tick(self):\n        try:\n"
            "            self.drive()\n        except Exception:\n            return\n\n"
            "    def drive(self):\n        Twist().linear.x = 1\n\nrclpy.init()\nrclpy.spin(Mine())\n"
        ),
        ("swallowed",),
    ),
    Drill(
        "i1c",
        "except: pass in a pool of threads",
        beside(
            SLOW, NODE + HEARS.format("    try:\n        return 1 / 0\n    except Exception:\n        pass") + POOLED
        ),
        ("swallowed",),
    ),
    # -- too fast ------------------------------------------------------------------------------------------------------
    Drill(
        "i2",
        "a timer of 1e-7 s",
        program(spinning("node.create_timer(1e-7, lambda: None)\n")),
        ("timer_late",),
    ),
    Drill(
        "i2b",
        "a timer's callback longer than its period",
        program(spinning("node.create_timer(0.05, lambda: time.sleep(0.2))\n")),
        ("timer_late",),
    ),
    Drill(
        "i2c",
        "a timer of 0 s",
        program(spinning("node.create_timer(0.0, lambda: None)\n")),
        ("timer_zero",),
    ),
    Drill(
        "i2d",
        "a timer in milliseconds",
        program(spinning("node.create_timer(500, print)\nnode.create_timer(1000, lambda: None)\n")),
        ("timer_seldom",),
    ),
    Drill(
        "i3",
        "most of 500 Hz is lost",
        beside(FAST, spinning(HEARS.format("    time.sleep(0.3)"))),
        ("losses",),
    ),
    Drill(
        "i3b",
        "published without a pause",
        program(
            NODE
            + "publisher = node.create_publisher(String, 'chatter', 10)\nwhile rclpy.ok():\n    publisher.publish(String())\n"
        ),
        ("flood",),
    ),
    Drill(
        "i3c",
        "a publisher made in a callback",
        program(
            spinning(
                "node.create_timer(0.05, lambda: node.create_publisher(String, 'chatter', 10).publish(String()))\n"
            )
        ),
        ("grows_publishers",),
    ),
    Drill(
        "i3d",
        "a timer made in a callback",
        program(spinning("def tick():\n    node.create_timer(5.0, tick)\nnode.create_timer(0.1, tick)\n")),
        ("grows_timers",),
    ),
    # -- actions -------------------------------------------------------------------------------------------------------
    Drill(
        "i4",
        "an action never succeeds",
        program(
            ACTION
            + spinning(
                "def execute(goal):\n    print('begun', flush=True)\n    return Fibonacci.Result()\n"
                "server = ActionServer(node, Fibonacci, 'fibonacci', execute)\n" + ASKS
            ),
            shows="begun",
        ),
        ("goal_unsettled",),
    ),
    Drill(
        "i4b",
        "an accepted goal that nobody executes",
        program(
            ACTION
            + spinning(
                "def accepted(goal):\n    print('accepted', flush=True)\n"
                "server = ActionServer(node, Fibonacci, 'fibonacci', print, handle_accepted_callback=accepted)\n" + ASKS
            ),
            shows="accepted",
        ),
        ("goal_waits",),
    ),
    Drill(
        "i4c",
        "an action that cannot be canceled",
        canceled(
            "def execute(goal):\n    while rclpy.ok():\n        time.sleep(0.1)\n    return Fibonacci.Result()\n"
            "server = ActionServer(node, Fibonacci, 'fibonacci', execute,\n"
            "                      cancel_callback=lambda goal: CancelResponse.ACCEPT)\n" + POOLED
        ),
        ("cancel_ignored",),
    ),
    Drill(
        "i4d",
        "a cancellation that no thread can take",
        canceled(
            "def execute(goal):\n    while rclpy.ok() and not goal.is_cancel_requested:\n        time.sleep(0.1)\n"
            "    return Fibonacci.Result()\n"
            "server = ActionServer(node, Fibonacci, 'fibonacci', execute,\n"
            "                      cancel_callback=lambda goal: CancelResponse.ACCEPT)\n" + SPIN
        ),
        ("cancel_unheard",),
    ),
    # -- threads -------------------------------------------------------------------------------------------------------
    Drill("i5", "a thread died, the node goes on", program(DYING_THREAD), ("thread_died",)),
    Drill("i5b", "the same in the background", background, ("thread_died",)),
    Drill(
        "i5c",
        "the thread that spins died",
        program(
            "import threading\n" + NODE + "def tick():\n    print(node.speed)\nnode.create_timer(0.1, tick)\n"
            "threading.Thread(target=rclpy.spin, args=(node,)).start()\nwhile True:\n    time.sleep(1)\n"
        ),
        ("thread_died",),
    ),
    # -- who waits for whom --------------------------------------------------------------------------------------------
    Drill(
        "i6",
        "call() in a callback, served elsewhere",
        beside(SERVES, CLIENT.format("    client.call(Trigger.Request())")),
        ("calls_in_callback",),
    ),
    Drill("i6b", "call() within one exclusive group", beside(SERVES, GROUPED), ("calls_in_group",)),
    Drill(
        "i6c",
        "the service is in the group of who calls",
        program(GROUPED_SERVER),
        ("calls_own_in_group",),
    ),
    Drill(
        "i6d",
        "a loop until a future is done",
        beside(
            SERVES,
            CLIENT.format(
                "    future = client.call_async(Trigger.Request())\n    while not future.done():\n        time.sleep(0.01)"
            ),
        ),
        ("calls_in_callback",),
    ),
    Drill(
        "i6e",
        "an event that another callback sets",
        program(
            "import threading\n"
            + spinning(
                "came = threading.Event()\n"
                "node.create_timer(0.2, lambda: came.wait())\nnode.create_timer(0.3, lambda: came.set())\n"
            )
        ),
        ("event_in_callback",),
    ),
    Drill(
        "i6f",
        "input() in a callback",
        program(spinning("node.create_timer(0.2, lambda: input('speed? '))\n"), shows="speed?"),
        ("input_in_callback",),
    ),
    Drill(
        "i6g",
        "while True in __init__",
        program(
            "class Mine(Node):\n    def __init__(self):\n        super().__init__('mine')\n"
            "        self.publisher = self.create_publisher(String, 'chatter', 10)\n"
            "        self.create_timer(0.1, print)\n        while True:\n"
            "            self.publisher.publish(String())\n            time.sleep(0.1)\n\nrclpy.init()\nrclpy.spin(Mine())\n"
        ),
        ("stays_in_init",),
    ),
    Drill(
        "i6h",
        "the second spin is never reached",
        program(
            spinning("second = Node('second')\nsecond.create_timer(0.1, print)\nnode.create_timer(0.1, lambda: None)\n")
            + "rclpy.spin(second)\n",
            node="/second",
        ),
        ("never_spun",),
    ),
    Drill(
        "i6i",
        "waits for a service with a slip in its name",
        beside(SERVES, NODE + "node.create_client(Trigger, 'triger').wait_for_service()\n"),
        ("program_waits_near",),
    ),
    Drill(
        "i6j",
        "waits for a service of another type",
        beside(
            SERVES,
            "from std_srvs.srv import SetBool\n" + NODE + "node.create_client(SetBool, 'trigger').wait_for_service()\n",
        ),
        ("program_waits_type",),
    ),
    # -- synchronizers -------------------------------------------------------------------------------------------------
    Drill(
        "i7",
        "stamps too far apart",
        program(
            SYNC + IMAGES + "node.create_timer(0.1, lambda: sent(scans, LaserScan(), 1000))\n"
            "matched = ApproximateTimeSynchronizer(inputs, 10, 0.1)\nmatched.registerCallback(both)\n" + SPIN
        ),
        ("sync_stamps",),
    ),
    Drill(
        "i7b",
        "the queue is too short",
        program(
            SYNC + "node.create_timer(0.01, lambda: sent(images, Image()))\n"
            "node.create_timer(0.2, lambda: sent(scans, LaserScan(), 0.5))\n"
            "matched = ApproximateTimeSynchronizer(inputs, 5, 0.02)\nmatched.registerCallback(both)\n" + SPIN
        ),
        ("sync_queue",),
    ),
    Drill(
        "i7c",
        "QoS keeps one input silent",
        program(
            SYNC.replace("'scan', 10)", "'scan', QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT))")
            + IMAGES
            + "node.create_timer(0.1, lambda: sent(scans, LaserScan()))\n"
            "matched = ApproximateTimeSynchronizer(inputs, 10, 0.1)\nmatched.registerCallback(both)\n" + SPIN
        ),
        ("qos",),
    ),
    Drill(
        "i7d",
        "exactly equal stamps are wanted",
        program(
            SYNC + IMAGES + "node.create_timer(0.1, lambda: sent(scans, LaserScan(), 0.003))\n"
            "matched = TimeSynchronizer(inputs, 10)\nmatched.registerCallback(both)\n" + SPIN
        ),
        ("sync_exact",),
    ),
    Drill(
        "i7e",
        "messages without a header",
        program(
            SYNC + IMAGES + "texts = node.create_publisher(String, 'text', 10)\n"
            "node.create_timer(0.1, lambda: texts.publish(String()))\n"
            "inputs[1] = Subscriber(node, String, 'text')\n"
            "matched = ApproximateTimeSynchronizer(inputs, 10, 0.1)\nmatched.registerCallback(both)\n" + SPIN
        ),
        ("sync_timeless",),
    ),
    Drill(
        "i7f",
        "registerCallback forgotten",
        program(
            SYNC + IMAGES + "node.create_timer(0.1, lambda: sent(scans, LaserScan()))\n"
            "matched = ApproximateTimeSynchronizer(inputs, 10, 0.1)\n" + SPIN
        ),
        ("sync_no_callback",),
    ),
    Drill(
        "i7g",
        "a callback with one argument too few",
        program(
            SYNC + IMAGES + "node.create_timer(0.1, lambda: sent(scans, LaserScan()))\n"
            "matched = ApproximateTimeSynchronizer(inputs, 10, 0.1)\nmatched.registerCallback(lambda image: None)\n"
            + SPIN,
            ends=True,
        ),
        ("exception",),
    ),
    # -- parameters and launch -----------------------------------------------------------------------------------------
    Drill(
        "i8",
        "[] as a parameter",
        program(spinning("node.declare_parameter('names', [])\n")),
        ("empty_list",),
    ),
    Drill(
        "i8b",
        "[] as a parameter, and a list for it",
        lambda lab: (
            lab.file("program.py", HEAD + NODE + "node.declare_parameter('names', [])\n"),
            lab.run("python3 program.py --ros-args -p \"names:=['a', 'b']\""),
        ),
        ("list_type",),
    ),
    Drill(
        "i9",
        "a launch value made a text in a parameter",
        launched("Node(executable=program, parameters=[{'speed': f'{speed}'}], output='screen')", shows="up"),
        ("launch_text", "launch_argument"),
    ),
    Drill(
        "i9b",
        "a launch value made a text in an argument",
        launched("ExecuteProcess(cmd=['python3', program, '--speed=' + str(speed)], output='screen')", shows="up"),
        ("launch_argument",),
    ),
)
