"""电机控制: one row a motor."""
