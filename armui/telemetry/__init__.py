"""Feedback and commands over time: series with pyramids of minima and maxima.

Pure: no Qt, no bus. The bus thread writes, every other thread may read.
"""
