"""Forward and inverse kinematics, tool paths and their pace; knows numbers only."""
