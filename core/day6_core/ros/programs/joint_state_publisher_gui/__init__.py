"""joint_state_publisher_gui 2.4.0 (Jazzy): joint_state_publisher with a window of sliders."""
