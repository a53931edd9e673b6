"""Sessions as they happen: what the operator has recorded and saved of them."""
