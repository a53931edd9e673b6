"""What a log says, in formats that other programs open: MCAP with ROS 2 messages, CSV, Parquet."""
