"""The local interface: other programs of this user move the arm through this one (B26)."""
