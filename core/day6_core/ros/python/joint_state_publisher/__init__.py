"""What programs import of joint_state_publisher."""
