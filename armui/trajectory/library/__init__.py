"""The folder of trajectories: files, index, history, bin and drafts."""
