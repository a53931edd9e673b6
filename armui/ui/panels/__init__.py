"""The panels of the operation area, one file each.

Parts used by one panel only are beside it. Panels do not import each other.
"""
