"""The simulated arm: it behaves as the protocol text says and as the firmware is known to.

It has no Qt; only `armui.app`, `armui.cli` and tests start one.
"""
