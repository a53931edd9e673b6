"""轨迹库: the library of trajectories, the editor of one, running and recording them."""
