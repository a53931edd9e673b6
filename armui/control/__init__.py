"""Every action of the operator: checked, sent, and followed to its end.

The windows call :class:`armui.control.arm_controller.ArmController`; no widgets here.
"""
