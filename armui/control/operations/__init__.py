"""What an operator can do to the arm: a declaration for each action, beside what sends it."""
