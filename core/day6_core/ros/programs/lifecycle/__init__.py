"""The demo of real ROS's package lifecycle: a managed talker, a listener, and a client that leads it through its states."""
