"""The arm as the program knows it: state, limits, kinematics; without Qt and without a bus."""
