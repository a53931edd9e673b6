"""The arm as the program knows it: state, limits, reach; without Qt and without a bus. Pure."""
