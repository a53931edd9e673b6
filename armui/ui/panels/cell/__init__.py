"""单元: the panel of the cell, with a tab for each part of it."""
