"""rqt_service_caller: calls any service. `model` is what the window reads, `rqt_service_caller` is the program."""
