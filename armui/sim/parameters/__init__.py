"""The values a simulated arm keeps, and how they are asked for and set."""
