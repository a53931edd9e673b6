"""The windows and marks of the local interface, and the operator's grants."""
