"""Acts: each button of a panel, page or dialog is declared once, on its class."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import chain
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QAbstractButton, QCheckBox, QPushButton, QToolButton

from armui.arm.refusal import Refusal
from armui.control.operations.operation import Operation, operation_of
from armui.ui import words
from armui.ui.actions.command import Command, Needs, Target, no_reason
from armui.ui.actions.keys import SHORTCUTS, keys_of
from armui.ui.actions.operator_view import why_taken
from armui.ui.widgets.buttons import (
    bar_button,
    enable_or_explain,
    named,
    push_button,
    show_primary,
)
from armui.ui.widgets.hold_button import HoldButton
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_Key = TypeVar("_Key")
_Method = TypeVar("_Method", bound=Callable[..., object])


class _Marks:
    """Decorators for the methods of an act; those of a family are called with the key."""

    def mark(self, what: str, method: _Method) -> _Method:
        """Register a method for one purpose, such as ``pressed``."""
        raise NotImplementedError

    def pressed(self, method: _Method) -> _Method:
        """Mark the method that is called when it is pressed, or was held."""
        return self.mark("pressed", method)

    def why_not(self, method: _Method) -> _Method:
        """Mark the method that returns why it cannot be pressed: a refusal, words, or nothing."""
        return self.mark("why_not", method)

    def text(self, method: _Method) -> _Method:
        """Mark the method that returns its text, where that changes."""
        return self.mark("text", method)

    def tip(self, method: _Method) -> _Method:
        """Mark the method that returns its purpose, where that changes."""
        return self.mark("tip", method)

    def whose(self, method: _Method) -> _Method:
        """Mark the method that returns the owner's name, if that is not the heading."""
        return self.mark("whose", method)

    def lit(self, method: _Method) -> _Method:
        """Mark the method that returns whether to highlight the button, if it can be pressed."""
        return self.mark("lit", method)

    def there(self, method: _Method) -> _Method:
        """Mark the method that returns whether the button is shown at all."""
        return self.mark("there", method)


class Act(_Marks):
    """A button with its action, its reason, its texts and its command, declared once.

    It is a class attribute of the widget that shows it. Read from an instance, it gives that
    instance's button, created at the first use. Its texts are translated in the context of the
    class. What does not fit into one line is a method of the class, marked by a decorator::

        confirm = Act("Confirm", named="light_confirm_button", does=Lights.set_light)

        @confirm.pressed
        def _on_confirm(self) -> None: ...

    It can be pressed while neither its operation nor `needs` gives a reason against it; a method
    marked by :meth:`why_not` replaces both. An act without :meth:`pressed` gets a menu from its
    owner.

    Args:
        text: The English text on it; a ``Text`` if that belongs to another context.
        named: Its object name.
        does: The method of the controller's part that it leads to, declared as an operation.
        arguments: The arguments that the reason of the operation depends on.
        tip: The purpose in English, for the tooltip while it can be pressed; a ``Text`` as above.
        whose: The name of what it belongs to, which a screen reader reads before its text; True
            for the heading of its owner, see :meth:`HasActs.heading`.
        key: The name of its command in the palette, which its shortcut has as well; "" for none.
        shortcut: The name of its shortcut, if it is not `key`; "" if the button has no keys,
            because they only work in a list.
        title: The title in the palette; without it that of the shortcut or of the operation, or
            its text.
        needs: As in :class:`Command`.
        leads: As in :class:`Command`.
        risky: As in :class:`Command`.
        synonyms: As in :class:`Command`.
        primary: True for the main button; see :meth:`lit`.
        held: True if it must be held for a second.
        flat: True for a button without a frame, as in the head of a panel.
        kind: Makes a button with a state from its object name, as :func:`toggle_button` and
            :func:`check_box` do; its state has changed when :meth:`pressed` is called.
        on_enter: True if Enter presses it anywhere in its dialog.
        least_height_px: Its least height.
    """

    def __init__(
        self,
        text: str | Text,
        *,
        named: str,
        does: Callable[..., object] | None = None,
        arguments: Mapping[str, object] | None = None,
        tip: str | Text = "",
        whose: bool | Text = False,
        key: str = "",
        shortcut: str | None = None,
        title: Text | None = None,
        needs: Needs = no_reason,
        leads: bool = False,
        risky: bool = False,
        synonyms: tuple[str, ...] = (),
        primary: bool = False,
        held: bool = False,
        flat: bool = False,
        kind: Callable[[str], QAbstractButton] | None = None,
        on_enter: bool = False,
        least_height_px: int = 0,
    ) -> None:
        self.named = named
        self.key = key
        self.operation: Operation | None = None if does is None else operation_of(does)
        self.arguments = dict(arguments or {})
        self._label, self._use = text, tip
        self._shortcut = key if shortcut is None else shortcut
        self._whose = whose
        self._title, self._needs = title, needs
        self._leads, self._risky, self._synonyms = leads, risky, synonyms
        self._primary, self._held, self._flat, self._kind = primary, held, flat, kind
        self._on_enter = on_enter
        self._least_height_px = least_height_px
        self._context = ""
        self._methods: dict[str, str] = {}
        self._member: tuple[object, ...] = ()

    # -- what its class says about it ---------------------------------------------------------

    def __set_name__(self, owner: type, _name: str) -> None:
        self.declared_in(owner.__name__)

    def declared_in(self, context: str) -> None:
        """Take over the name of the class as the context of the texts."""
        self._context = context

    def join(self, methods: dict[str, str], key: object) -> None:
        """Become a member of a family: share its methods, which are called with the key."""
        self._methods, self._member = methods, (key,)

    def mark(self, what: str, method: _Method) -> _Method:
        """Register a method for one purpose, such as ``pressed``."""
        self._methods[what] = method.__name__
        return method

    @property
    def command(self) -> Command | None:
        """The command in the palette, or ``None`` for an act without a key."""
        if not self.key:
            return None
        named_elsewhere = self.operation is not None or self.key in SHORTCUTS
        title = self._title or (None if named_elsewhere else self._text(self._label))
        return Command(
            *(self.key, title, self.operation, self.arguments),
            needs=self._needs,
            leads=self._leads,
            presses=not self._held,
            risky=self._risky,
            synonyms=self._synonyms,
        )

    # -- the button of an instance ------------------------------------------------------------

    @overload
    def __get__(self, owner: None, kind: type) -> Act: ...
    @overload
    def __get__(self, owner: HasActs, kind: type) -> QAbstractButton: ...
    def __get__(self, owner: HasActs | None, kind: type) -> Act | QAbstractButton:
        """Return the button of a widget; the declaration itself if it is read from the class."""
        return self if owner is None else self.button(owner)

    def button(self, owner: HasActs) -> QAbstractButton:
        """Return its button on a widget; it is made at the first use."""
        return owner.button_of(self)

    def make(self, owner: HasActs) -> QAbstractButton:
        """Return a new button that calls the widget's method."""
        button: QAbstractButton
        if self._held:
            hold = named(self.named, HoldButton(owner.controller))
            hold.held.connect(self._handler(owner))
            button = hold
        else:
            if self._kind is not None:
                button = self._kind(self.named)
            elif self._flat:
                button = named(self.named, QToolButton())
            else:
                button = push_button(self.named, primary=self._primary, on_enter=self._on_enter)
            if "pressed" in self._methods:
                button.clicked.connect(self._handler(owner))
        if self._least_height_px:
            button.setMinimumHeight(self._least_height_px)
        return button

    def _handler(self, owner: HasActs) -> Callable[[], object]:
        method: Callable[..., object] = getattr(owner, self._methods["pressed"])
        return partial(method, *self._member) if self._member else method

    def press(self, owner: HasActs) -> None:
        """Do what a press of the button does, if there is no reason against it.

        A button that must be held does nothing here: only the operator's finger may hold it (S11).
        """
        if self._held or self.reason(owner):
            return
        self.show(owner)  # update it first: a disabled button takes no click
        self.button(owner).click()

    def reason(self, owner: HasActs) -> str:
        """Return in words why it cannot be pressed now; "" if it can."""
        if taken := why_taken(self.key or self.named, self.operation):
            return taken
        if "why_not" in self._methods:
            refusal: Refusal | str | None = self._ask(owner, "why_not")
        elif self.operation is not None or self._needs is not no_reason:
            now = owner.controller.operating_state
            refusal = self._needs(now)
            if not refusal and self.operation is not None:
                refusal = self.operation.why_not(now, **self.arguments)
        else:
            refusal = None
        return refusal if isinstance(refusal, str) else words.why_not(refusal)

    def show(self, owner: HasActs) -> None:
        """Show its text in the present language, and whether it can be pressed, with the reason."""
        button = self.button(owner)
        text = self._ask(owner, "text", self._text(self._label).text)
        keys = keys_of(self._shortcut) if self._shortcut in SHORTCUTS else ""
        if button.text() != text:
            button.setText(text)
            if keys:
                # Qt removes the shortcut of a button whenever its text is set
                button.setShortcut(QKeySequence(keys))
        belongs = self._whose.text if isinstance(self._whose, Text) else owner.heading
        whose = self._ask(owner, "whose", belongs if self._whose else str)
        button.setAccessibleName(f"{whose}: {text}" if whose else text)
        use = self._ask(owner, "tip", self._text(self._use).text)
        enable_or_explain(button, self.reason(owner), use, key=keys)
        if "lit" in self._methods:
            show_primary(button, wanted=button.isEnabled() and self._ask(owner, "lit"))
        if "there" in self._methods:
            button.setVisible(self._ask(owner, "there"))

    def _ask(self, owner: HasActs, what: str, default: Callable[[], Any] = str) -> Any:
        """Return the result of the marked method, or the default without one."""
        if what not in self._methods:
            return default()
        return getattr(owner, self._methods[what])(*self._member)

    def _text(self, source: str | Text) -> Text:
        return source if isinstance(source, Text) else Text(self._context, source)


class ActFamily(_Marks, Generic[_Key]):
    """Buttons that differ in a key, as in the command they send: one declaration for all.

    It is read from an instance as the buttons by their keys; the methods that it marks are called
    with the key.

    Args:
        acts: The acts by their keys.
    """

    def __init__(self, acts: Mapping[_Key, Act]) -> None:
        self.acts = acts
        methods: dict[str, str] = {}
        for key, act in acts.items():
            act.join(methods, key)
        self._any = next(iter(acts.values()))

    def __set_name__(self, owner: type, _name: str) -> None:
        for act in self.acts.values():
            act.declared_in(owner.__name__)

    def mark(self, what: str, method: _Method) -> _Method:
        """Register a method for one purpose with all members."""
        return self._any.mark(what, method)

    @overload
    def __get__(self, owner: None, kind: type) -> ActFamily[_Key]: ...
    @overload
    def __get__(self, owner: HasActs, kind: type) -> Mapping[_Key, QAbstractButton]: ...
    def __get__(
        self, owner: HasActs | None, kind: type
    ) -> ActFamily[_Key] | Mapping[_Key, QAbstractButton]:
        """Return the buttons of a widget; the declaration itself if it is read from the class."""
        if owner is None:
            return self
        return {key: act.button(owner) for key, act in self.acts.items()}


class HasActs:
    """A mixin, placed before the Qt class, for widgets and their helpers whose class declares acts.

    Attributes:
        acts: The acts of the class, with those of its families.
        commands: Its commands for the palette: those written on the class, then those of its acts.
    """

    acts: Sequence[Act] = ()
    commands: Sequence[Command] = ()
    _controller: ArmController

    def __init_subclass__(cls, **options: object) -> None:
        super().__init_subclass__(**options)
        declared = [each for each in vars(cls).values() if isinstance(each, Act | ActFamily)]
        own = [act for each in declared for act in _acts_of(each)]
        cls.acts = (*cls.acts, *own)
        commands = (act.command for act in own)
        cls.commands = (*cls.commands, *(each for each in commands if each is not None))

    @property
    def controller(self) -> ArmController:
        """The controller of the arm; only acts that ask or move the arm need it."""
        return self._controller

    def heading(self) -> str:
        """Return the name of what the acts belong to, for a screen reader."""
        return ""

    def act_parts(self) -> Iterable[HasActs]:
        """Return the widgets in it that have acts of their own, which it offers as well."""
        return ()

    def button_of(self, act: Act) -> QAbstractButton:
        """Return the button of an act of this widget; it is made at the first use."""
        made: dict[Act, QAbstractButton] = self.__dict__.setdefault("_act_buttons", {})
        if act not in made:
            made[act] = act.make(self)
        return made[act]

    def show_acts(self) -> None:
        """Show of each act its text, and whether it can be used now."""
        for act in self.acts:
            act.show(self)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        targets: dict[str, Target] = {act.key: act.button(self) for act in self.acts if act.key}
        for part in self.act_parts():
            targets.update(part.command_targets())
        return targets

    def act_of(self, command: str) -> BoundAct | None:
        """Return the act of a command, or ``None`` if that leads to another widget."""
        own = (BoundAct(act, self) for act in self.acts if act.key == command)
        theirs = (act for part in self.act_parts() if (act := part.act_of(command)) is not None)
        return next(chain(own, theirs), None)


@dataclass(frozen=True, slots=True)
class BoundAct:
    """An act of one widget.

    Attributes:
        act: The declaration.
        owner: The widget.
    """

    act: Act
    owner: HasActs

    def reason(self) -> str:
        """Return in words why it cannot be pressed now; "" if it can."""
        return self.act.reason(self.owner)

    def press(self) -> None:
        """Do what a press of the button does, if there is no reason against it."""
        self.act.button(self.owner).window().activateWindow()
        self.act.press(self.owner)


def toggle_button(name: str) -> QPushButton:
    """Return a button of a bar that stays down until it is pressed again."""
    return bar_button(name, toggles=True)


def check_box(name: str) -> QCheckBox:
    """Return a box that can be ticked."""
    return named(name, QCheckBox())


def _acts_of(declared: Act | ActFamily[Any]) -> Iterable[Act]:
    return (declared,) if isinstance(declared, Act) else declared.acts.values()
