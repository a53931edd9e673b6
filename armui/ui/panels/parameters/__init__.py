"""Panels for the parameters the arm keeps."""
