"""Operations: each operator's action on the arm is declared once, at the method that does it."""
