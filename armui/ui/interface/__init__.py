"""What the operator sees of the local interface, and what he grants."""
