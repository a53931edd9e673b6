"""The live stream for Foxglove: sends measurements to viewers, and receives nothing from them."""
