"""The page 总线: every frame on the bus, what it says, how often it comes, and who sends it."""
