"""armui for language models: its local interface as tools of the Model Context Protocol (MCP)."""

__version__ = "0.1.0"
