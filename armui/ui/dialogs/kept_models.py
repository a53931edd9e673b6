"""Remembers the model of each arm by the adapter's serial number and the node number."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

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


class KeptModels:
    """The chosen models in the settings.

    Args:
        store: The settings; ``None`` keeps nothing.
    """

    def __init__(self, store: SettingsStore | None = None) -> None:
        self._store = store

    def of(self, device: Device, node: str = "") -> PiperModel | None:
        """Return the model chosen last for an arm, or ``None``.

        Args:
            device: Its device.
            node: Its node number, if known: two arms may be used on one adapter in turn.
        """
        kept = self._kept()
        model = kept.get(device.arm_key(node)) or kept.get(device.arm_key())
        return None if model is None else PiperModel(model)

    def of_node(self, device: Device, node: str) -> PiperModel | None:
        """Return the last model of an arm with this node number at this adapter, or ``None``."""
        model = self._kept().get(device.arm_key(node)) if node else None
        return None if model is None else PiperModel(model)

    def keep(self, device: Device, node: str = "") -> Refusal | None:
        """Store the model chosen for a device; return ``None``, or why it could not be written."""
        if self._store is None:
            return None
        keys = device.arm_key(), device.arm_key(node)
        return self._store.keep("models", dict.fromkeys(keys, device.model.value))

    def _kept(self) -> Mapping[str, str]:
        return {} if self._store is None else self._store.settings.models


class NodeKeeper(QObject):
    """Stores an arm's model by its node number as well, and recalls it when the arm reports that.

    It is kept once the arm's own feedback has confirmed it, and written at disconnecting: no file
    is touched while a device is open.

    Args:
        controller: Gives the arm's state.
        kept: The store of models.
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
    """Return the model chosen last of all, or the PiPER if there is none."""
    return PiperModel(next(reversed(list(models.values())), PiperModel.PIPER))
