import rclpy
from rclpy.lifecycle import *
from rclpy.lifecycle import TransitionCallbackReturn

rclpy.init()
n = LifecycleNode("lc")
m = n._state_machine
print(m.current_state, m.available_states)
for t in m.transition_graph:
    print(t)
print(m.available_transitions)
print(sorted(n.get_topic_names_and_types()))
for x in n.get_publishers_info_by_topic("/lc/transition_event"):
    print(x.qos_profile)
from lifecycle_msgs.msg import TransitionEvent

got = []
n.create_subscription(TransitionEvent, "~/transition_event", got.append, 10)
print(n.trigger_configure())
print(n.trigger_activate())
print(n.trigger_shutdown())
try:
    n.trigger_shutdown()
except Exception as e:
    print(type(e), e)
print(n.trigger_configure())
for i in range(10):
    rclpy.spin_once(n, timeout_sec=0.1)
for g in got:
    print(g)


class B(LifecycleNode):
    def on_configure(self, s):
        raise ValueError

    def on_error(self, s):
        print("onerr", s)
        return TransitionCallbackReturn.FAILURE


b = B("b")
print(b.trigger_configure(), b._state_machine.current_state)


class B2(LifecycleNode):
    def on_configure(self, s):
        return TransitionCallbackReturn.FAILURE


b = B2("b2")
print(b.trigger_configure(), b._state_machine.current_state)


class B3(LifecycleNode):
    def on_configure(self, s):
        return None


b = B3("b3")
try:
    print(b.trigger_configure(), b._state_machine.current_state)
except Exception as e:
    print(type(e), e)
print(TransitionCallbackReturn.SUCCESS.to_label())
try:
    m.get_transition_by_label("foo")
except Exception as e:
    print(type(e), e)
try:
    m.trigger_transition_by_label("foo", True)
except Exception as e:
    print(type(e), e)
try:
    m.trigger_transition_by_id(77, True)
except Exception as e:
    print(type(e), e)
