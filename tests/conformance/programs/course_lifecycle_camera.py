"""A lifecycle node through its states, with a publisher that is silent while inactive."""

import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String


class Camera(LifecycleNode):
    def on_configure(self, state):
        print("configure from", state.label, state.state_id)
        self.publisher = self.create_lifecycle_publisher(String, "image", 10)
        return super().on_configure(state)

    def on_activate(self, state):
        print("activate from", state.label)
        return super().on_activate(state)

    def on_deactivate(self, state):
        print("deactivate from", state.label)
        return super().on_deactivate(state)

    def on_cleanup(self, state):
        print("cleanup from", state.label)
        self.destroy_lifecycle_publisher(self.publisher)
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state):
        print("shutdown from", state.label)
        return TransitionCallbackReturn.SUCCESS


rclpy.init()
camera = Camera("camera")
listener = rclpy.create_node("listener")
got = []
listener.create_subscription(String, "image", lambda m: got.append(m.data), 10)
print(camera.trigger_configure(), camera.publisher.is_activated)
camera.publisher.publish(String(data="inactive"))
print(camera.trigger_activate(), camera.publisher.is_activated)
while camera.publisher.get_subscription_count() == 0:
    rclpy.spin_once(listener, timeout_sec=0.01)
camera.publisher.publish(String(data="active"))
rclpy.spin_once(listener, timeout_sec=1.0)
print(got)
print(camera.trigger_deactivate(), camera.trigger_cleanup(), camera.trigger_activate(), camera.trigger_shutdown())
print(camera._state_machine.current_state)
rclpy.shutdown()
