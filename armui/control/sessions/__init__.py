"""Sessions in the making: recording and saving them."""
