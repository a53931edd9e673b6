"""The values a simulated arm keeps: reading and setting by a host, and storage."""
