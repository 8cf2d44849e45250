"""rviz2: looks at the graph's robots, transforms and messages, and shows them in 3-D."""
