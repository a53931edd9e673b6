"""The panels of the operation area, one file each.

What only one panel uses stands beside it. No panel knows another.
"""
