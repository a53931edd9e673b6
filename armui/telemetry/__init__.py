"""What was heard and commanded, over time: series with their pyramids of minima and maxima.

Pure: no Qt, no bus. The bus thread writes, every other thread may read.
"""
