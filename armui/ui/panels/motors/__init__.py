"""电机控制: power, zero, errors and measurements of each motor, one row each."""
