"""Carries out every action of the operator: checks it, sends it, follows it to its end.

The windows call :class:`armui.control.arm_controller.ArmController`; no widgets here.
"""
