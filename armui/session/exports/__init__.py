"""Exports a log to formats of other programs: MCAP with ROS 2 messages, CSV, Parquet."""
