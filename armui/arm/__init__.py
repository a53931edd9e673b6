"""The arm's state, limits, parameters and reach; without Qt and without a bus. Pure."""
