"""urdfdom's tools, typed as commands of their own: `check_urdf` and `urdf_to_graphviz`. `day6_urdf` does the work."""
