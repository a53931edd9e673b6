"""An arm made of software, honest to the firmware; without Qt."""
