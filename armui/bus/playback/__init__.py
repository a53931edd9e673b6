"""A log in the place of the bus: there is nothing here that could send."""
