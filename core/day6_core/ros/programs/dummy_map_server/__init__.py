"""The executable of dummy_map_server."""
