"""Which model was chosen for which arm: kept by the adapter's serial number and the node number."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject

from armui.protocol.generation import PiperModel

if TYPE_CHECKING:
    from collections.abc import Mapping

    from armui.arm.device import Device
    from armui.arm.refusal import Refusal
    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.settings import SettingsStore

MOST: Final = 200
"""Arms that are remembered; those connected longest ago are forgotten."""


class KeptModels:
    """The choices in the settings.

    Args:
        store: The settings; ``None``: nothing is kept.
    """

    def __init__(self, store: SettingsStore | None = None) -> None:
        self._store = store

    def of(self, device: Device, node: str = "") -> PiperModel | None:
        """The model that was chosen last for an arm; ``None``: none was.

        Args:
            device: The way to it.
            node: Its node number, where it is known: two arms may be used on one adapter in turn.
        """
        kept = self._kept()
        model = kept.get(device.arm_key(node)) or kept.get(device.arm_key())
        return None if model is None else PiperModel(model)

    def of_node(self, device: Device, node: str) -> PiperModel | None:
        """The model that an arm with this node number had the last time at this adapter."""
        model = self._kept().get(device.arm_key(node)) if node else None
        return None if model is None else PiperModel(model)

    def keep(self, device: Device, node: str = "") -> Refusal | None:
        """Keep the model chosen for a device; ``None``, or why it could not be written."""
        if self._store is None:
            return None
        kept = dict(self._kept())
        for key in (device.arm_key(), device.arm_key(node)):
            kept.pop(key, None)
            kept[key] = device.model.value
        newest = dict(list(kept.items())[-MOST:])
        return None if newest == self._kept() else self._store.change(models=newest)

    def _kept(self) -> Mapping[str, str]:
        return {} if self._store is None else self._store.settings.models


class NodeKeeper(QObject):
    """Keeps the model of an arm by its node number, too, and recalls it when the arm names that.

    It is kept once the arm itself has confirmed it, and written when the arm is left: no file is
    touched while a device is open.

    Args:
        controller: Knows the arm.
        kept: Where it is kept.
    """

    def __init__(self, controller: ArmController, kept: KeptModels) -> None:
        super().__init__()
        self._controller = controller
        self._kept = kept
        self._confirmed: tuple[Device, str] | None = None
        self._recalled: tuple[Device, str] | None = None
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        controller.state_changed.connect(self._on_state_changed)

    def _on_state_changed(self, state: ArmState) -> None:
        device, identity = self._controller.operating_state.device, state.identity
        if device is None or identity is None or not identity.node_number:
            return
        arm = device, identity.node_number
        if arm == self._recalled:
            return
        self._recalled = arm
        model = self._kept.of_node(*arm)
        if model is not None:
            self._controller.model_watch.recall(model, identity.node_number)

    def _on_operating_state_changed(self, now: OperatingState) -> None:
        identity = self._controller.state.identity
        if now.device is None:
            self._recalled = None
            confirmed, self._confirmed = self._confirmed, None
            if confirmed is not None:
                self._kept.keep(*confirmed)
        elif now.model_fit.confirmed and identity is not None and identity.node_number:
            self._confirmed = replace(now.device, model=now.model), identity.node_number


def last_model(models: Mapping[str, str]) -> PiperModel:
    """The model that was chosen last of all; the PiPER where none was."""
    return PiperModel(next(reversed(list(models.values())), PiperModel.PIPER))
