"""joint_state_publisher 2.4.0 (Jazzy): publishes a robot's joint positions on /joint_states while nothing measures them."""
