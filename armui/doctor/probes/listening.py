"""Listens to a device for a moment; asks questions only when told to."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from armui.doctor.facts import HeardFacts
from armui.system.command_process import is_packaged
from armui.telemetry.bus_errors import BusError, errors_of

if TYPE_CHECKING:
    import can

    from armui.arm.device import Device
    from armui.protocol.frame import Frame

_MOST_FRAMES: Final = 60_000
"""The most frames: some seven seconds of a full bus."""
_WAIT_S: Final = 0.05
_PAUSE_S: Final = 0.02
"""The pause between questions: an answer of eleven frames must not be cut by the next."""


def listen(
    device: Device,
    seconds: float,
    *,
    ask: bool = False,
    clock_s: Callable[[], float] = time.monotonic,
) -> HeardFacts:
    """Return the facts heard on a device; never raises.

    Args:
        device: The device. Its bit rate is set if the program is in charge of it.
        seconds: The time to listen.
        ask: True to send questions, too: for the version, limits, accelerations, teaching handle.
        clock_s: Returns the time in seconds.
    """
    channel = str(device.channel)
    try:
        from armui.bus.adapters import explain, open_bus  # noqa: PLC0415 - may be missing
    except ImportError as error:
        return HeardFacts(
            device.interface,
            channel,
            problem="bus_backend_not_packed" if is_packaged() else "bus_backend_missing",
            problem_text=str(error),
            package=error.name or "python-can",
        )
    try:
        bus = open_bus(device)
    except Exception as error:  # noqa: BLE001 - third-party drivers may raise anything
        reason = explain(device, error)
        return HeardFacts(
            device.interface,
            channel,
            problem=reason.code,
            problem_text=str(error) or type(error).__name__,
            package=str(reason.params.get("package", "")),
        )
    try:
        return _hear(bus, device, seconds, ask=ask, clock_s=clock_s)
    except Exception as error:  # noqa: BLE001 - a device may go away at any moment
        reason = explain(device, error)
        text = str(error) or type(error).__name__
        return HeardFacts(device.interface, channel, problem=reason.code, problem_text=text)
    finally:
        bus.shutdown()


def _hear(
    bus: can.BusABC, device: Device, seconds: float, *, ask: bool, clock_s: Callable[[], float]
) -> HeardFacts:
    from armui.doctor.hearing import TimedFrame, heard_facts  # noqa: PLC0415 - numpy may be missing
    from armui.protocol.frame import Frame  # noqa: PLC0415 - as above

    frames: list[TimedFrame] = []
    echoes: list[Frame] = []
    errors, bus_off = 0, False
    questions = _questions() if ask else []
    asked = frozenset(each.arbitration_id for each in questions)
    began_s = clock_s()
    next_question_s = began_s + seconds / 4
    while (now_s := clock_s()) - began_s < seconds:
        if questions and now_s >= next_question_s:
            question = questions.pop(0)
            _send(bus, question)
            echoes.append(question)
            next_question_s = now_s + _PAUSE_S
        message = bus.recv(_PAUSE_S if questions else _WAIT_S)
        if message is None:
            continue
        if message.is_error_frame:
            errors += 1
            told = errors_of(message.arbitration_id, bytes(message.data), device.interface)
            bus_off = bus_off or BusError.BUS_OFF in told
        elif _is_of_the_protocol(message) and len(frames) < _MOST_FRAMES:
            frame = Frame(message.arbitration_id, bytes(message.data))
            if frame in echoes:  # some back-ends echo sent frames
                echoes.remove(frame)
            else:
                frames.append(TimedFrame(clock_s(), frame))
    return heard_facts(
        device.interface,
        str(device.channel),
        frames,
        seconds=seconds,
        error_frames=errors,
        bus_off=bus_off,
        asked=asked,
    )


def _is_of_the_protocol(message: can.Message) -> bool:
    return not (message.is_extended_id or message.is_remote_frame or message.is_fd)


def _questions() -> list[Frame]:
    """Return the frames of questions that every arm answers and that change nothing."""
    from armui.protocol import commands  # noqa: PLC0415 - cantools may be missing
    from armui.protocol.codec import Codec  # noqa: PLC0415 - as above
    from armui.protocol.generation import Generation  # noqa: PLC0415 - as above

    codec = Codec(Generation.TWO)
    questions = [*commands.query_teaching(codec)]
    for joint in range(1, 7):
        questions += commands.query_limits(codec, joint)
        questions += commands.query_acceleration(codec, joint)
    return [*questions, *commands.query_firmware(codec)]


def _send(bus: can.BusABC, frame: Frame) -> None:
    import can  # noqa: PLC0415 - loaded only where it was already found

    message = can.Message(
        arbitration_id=frame.arbitration_id, data=frame.data, is_extended_id=False
    )
    bus.send(message, timeout=_PAUSE_S)
