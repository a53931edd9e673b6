"""The folder that keeps trajectories: files, index, history, bin and drafts."""
