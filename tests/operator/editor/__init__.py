"""An operator at the second level of 轨迹库: the points of one trajectory, edited."""
