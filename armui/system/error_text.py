"""What an exception says, for a sentence to the operator."""


def error_text(error: BaseException) -> str:
    """Of the system's errors its words without number and path, of others theirs, or the kind."""
    return getattr(error, "strerror", None) or str(error) or type(error).__name__
