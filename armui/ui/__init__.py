"""The windows: they show the state they are given and call the controller, never the bus."""
