"""The page 总线: every frame on the bus, with its meaning, its rate and its sender."""
