"""Estimates in the background how long the chosen run will take, before any check."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QObject, QTimer, Signal

from armui.arm.refusal import Refusal
from armui.control.run.replay import FULL_PERCENT
from armui.trajectory.planning.estimate import estimates_s
from armui.trajectory.samples.recording import Recording
from armui.ui.background import Job

if TYPE_CHECKING:
    from armui.control.run.preflight import Checks, Preflight
    from armui.trajectory.files import Content
    from armui.trajectory.library.run_options import RunOptions

_PAUSE_MS: Final = 300
"""The pause after a change before the time is worked out, as figures are typed digit by digit."""


def estimate_tip(*, known: bool, from_here: bool = False, in_list: bool = False) -> str:
    """Return the tooltip of an estimate, or the reason why there is none.

    Args:
        known: True if there is one.
        from_here: True if it counts the way from where the arm stands.
        in_list: True if it is that of the file, which no check of a run changes.
    """
    if known and from_here:
        return QCoreApplication.translate(
            "RunEstimate", "An estimate, from where the arm stands. A check tells it exactly."
        )
    if known and in_list:
        return QCoreApplication.translate(
            "RunEstimate", "An estimate, from the first point to the last."
        )
    if known:
        return QCoreApplication.translate(
            "RunEstimate",
            "An estimate, without the way to the first point. A check tells it exactly.",
        )
    return QCoreApplication.translate(
        "RunEstimate",
        "How long it takes is not known: the arm cannot reach a point or go a way, or there are "
        "too many points. A check tells more.",
    )


class RunEstimate(QObject):
    """Keeps the time that the chosen run takes; the figure of a check replaces the estimate.

    Args:
        checks: Works the time out.
        content: Hands on the content that would be run now, once it is read, or ``None``. It
            tells the operator nothing.
        options: Returns the options of a run that began now.
        percent: Returns the speed at which it would begin.
        parent: Its owner.

    Signals:
        changed: Another time is known, or none.

    Attributes:
        seconds: The time of the run at 100 %; ``None`` where it is not known.
        slowed_s: Its time at the operator's speed.
        is_checked: True if a check worked that at 100 % out, from where the arm stood then.
        from_here: True if it counts the way from where the arm stands to the first point.
        is_asked: True while the time is being worked out.
    """

    changed = Signal()

    def __init__(
        self,
        checks: Checks,
        content: Callable[[Callable[[Content | None], object]], object],
        options: Callable[[], RunOptions],
        percent: Callable[[], int],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._checks = checks
        self._content = content
        self._options = options
        self._percent = percent
        self._of: tuple[object, object] | None = None
        self._job: Job[tuple[float | None, ...]] | None = None
        self.seconds: float | None = None
        self.slowed_s: float | None = None
        self.is_checked = False
        self.is_asked = False
        self.from_here = False
        self._pause = QTimer(self, singleShot=True, interval=_PAUSE_MS)
        self._pause.timeout.connect(self._begin)

    def follow(self, what: object, *, wanted: bool) -> None:
        """Take over the selection; an unchanged one has no effect.

        Args:
            what: A value that changes with everything the time depends on, except the arm.
            wanted: True if the time is seen, and there is something to be run.
        """
        if not wanted:
            if self.is_asked:
                self.renew()
            return  # the selection is empty for a moment while a list is rebuilt: keep the time
        here = self._checks.stands_at_deg
        chosen = (what, self._options(), self._percent(), self._checks.arm.fingerprint)
        if here is None and self._of is not None and self._of[0] == chosen:
            return  # keep the time while the arm moves or is silent
        of = (chosen, here)
        if of != self._of:
            self._forget()
            self._of, self.is_asked = of, True
            self._pause.start()

    def renew(self) -> None:
        """Compute the time again, because the content has changed under the same name."""
        self._of = None
        self._forget()

    def take(self, checked: Preflight) -> None:
        """Take over the time that a check of this run found; without end that of a further cycle.

        A check counts no slower speed of the operator's, for which the estimate holds; and the
        slow way to a recording, which is left out here.
        """
        cycles, path, options = checked.order.cycles, checked.path, self._options()
        as_chosen = (cycles, checked.order.first) == (options.cycles, options.first)
        as_chosen = as_chosen and not isinstance(checked.content, Recording)
        if self._of is not None and as_chosen and not checked.errors:
            first_s = path.first_cycle_s
            self.seconds = first_s + (cycles - 1) * path.lap_s if cycles else path.lap_s
            self.is_checked = True
            self.changed.emit()

    def _forget(self) -> None:
        self._pause.stop()
        if self._job is not None:
            self._job.wanted = False
            self._job = None
        self.seconds = self.slowed_s = None
        self.is_checked = self.is_asked = False

    def _begin(self) -> None:
        asked = self._of

        def read(content: Content | None) -> None:
            if self._of is asked and asked is not None and content is not None:
                here = self._checks.stands_at_deg is not None
                options, percents = self._options(), (FULL_PERCENT, self._percent())
                counts = bool(options.cycles) and not isinstance(content, Recording)
                self.from_here = here and counts
                self._job = Job(self._on_known)
                arm, stands_at_deg = self._checks.arm, self._checks.stands_at_deg
                self._checks.background.begin(
                    *(self._job, estimates_s, content, arm, options, percents, stands_at_deg)
                )

        self._content(read)

    def _on_known(self, known: tuple[float | None, ...] | Refusal) -> None:
        self._job, self.is_asked = None, False
        seconds, self.slowed_s = (None, None) if isinstance(known, Refusal) else known
        self.seconds = self.seconds if self.is_checked else seconds
        self.changed.emit()
