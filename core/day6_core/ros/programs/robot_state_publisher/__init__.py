"""robot_state_publisher 3.3.3 (Jazzy): turns a robot description and /joint_states into /tf and /tf_static."""
