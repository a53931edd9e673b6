"""Ways of the arm, and what is asked of each before it is taken: pure."""
