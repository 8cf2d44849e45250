"""joint_state_publisher 2.4.0 (Jazzy): says on /joint_states where a robot's joints are while nothing measures them."""
