"""Operations: each action of the operator on the arm is declared once, beside what sends it."""
