"""配速设置: how fast the end of the arm may move and speed up (manual section 1.0.7.5)."""

from __future__ import annotations

from armui.arm.parameters import Group
from armui.arm.refusal import Refusal
from armui.ui.panels.parameters.listed_parameters import ListedParameters


class EndLimitsPanel(ListedParameters):
    """Four limits of the end, and 【初始化】."""

    name = "end_limits"
    group = Group.END_LIMITS
    can_reset = True

    def title(self) -> str:
        """配速设置."""
        return self.tr("End speed limits")

    def reset_question(self) -> tuple[str, str]:
        """Before the end gets the factory's limits."""
        return (
            self.tr("Factory limits for the end"),
            self.tr(
                "The greatest speeds and accelerations of the end become what they were when the "
                "arm left the factory: straight lines and arcs may run faster than they do now."
            ),
        )

    def reset_to_factory(self) -> Refusal | None:
        """Ask the arm for its factory values."""
        return self._settings.reset_end_limits()
