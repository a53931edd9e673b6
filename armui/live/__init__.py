"""The live stream for Foxglove: what is measured, sent to viewers; nothing comes back."""
