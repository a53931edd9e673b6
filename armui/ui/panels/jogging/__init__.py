"""The panels that move the arm: joints, end pose and held jogging."""
