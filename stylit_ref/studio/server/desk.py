"""The one painting of a studio, its engine, and the pages around it."""

import asyncio
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from datetime import datetime
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.studio.engine.events import Event
from stylit_ref.studio.engine.live import Live
from stylit_ref.studio.engine.painting import check_painting
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.painting.easel import LEAP, Easel
from stylit_ref.studio.painting.folder import Saved, Setting
from stylit_ref.studio.scene_files.offer import Offer
from stylit_ref.studio.server import protocol
from stylit_ref.studio.server.beginning import Beginning, folder_of
from stylit_ref.studio.server.protocol import Paint, Wish, painting_bytes, said, sentence
from stylit_ref.studio.server.telling import Telling
from stylit_ref.studio.server.visitors import Visitor, Visitors
from stylit_ref.studio.server.welcome import panels_of_scene, welcome

Engine = Callable[[Scene, NDArray[np.uint8], Callable[[Event], None], int], Live]
"""Begins one: of a scene, a painting, where events go, and a seed."""

LOOKS_ON = "This page looks on. Take over to paint here."

READERS_WAIT = 0.1
"""Seconds between two paintings that readers are sent."""


class Desk:
    """All that pages share. It belongs to the event loop; threads hand things over to it.

    Parameters
    ----------
    beginning : Beginning
    engine : callable
    panels : sequence of str
        Parts of the page that this studio has.

    Attributes
    ----------
    left_behind : int
        What has at most this serial was painted on a painting whose place another has taken.
    """

    def __init__(self, beginning: Beginning, engine: Engine, panels: Sequence[str]) -> None:
        self._shelf, self._panels = beginning.shelf, panels
        self._notes = list(beginning.notes)
        self._loop = asyncio.get_running_loop()
        self._opening = asyncio.Lock()  # of a scene
        self._visitors = Visitors()
        self._telling = Telling(self._visitors)
        self._folder, saved, self._scene = beginning.folder, beginning.saved, beginning.scene
        self._easel = self._new_easel(self._shelf.offer(self._scene.name), saved)
        tell = self.from_thread(self._telling.pass_on)
        self._live = engine(self._scene, saved.painting.copy(), tell, saved.setting.seed)
        self._restore()
        self._readers_are_due = False
        self.left_behind: int = -1

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the painting."""
        return self._easel.size

    @property
    def offer(self) -> Offer:
        """The scene that is open."""
        return self._shelf.offer(self._scene.name)

    def from_thread(self, call: Callable[[Any], None]) -> Callable[[Any], None]:
        """What a thread may call, so that the event loop makes the call."""

        def hand_over(argument: Any) -> None:
            with suppress(RuntimeError):  # the loop has ended
                self._loop.call_soon_threadsafe(call, argument)

        return hand_over

    def close(self) -> None:
        """End the engine; return when all is saved.

        Raises
        ------
        InputError
            If the painting cannot be saved.
        """
        try:
            self._easel.close()
        finally:
            self._live.close()

    def knows(self, visitor: Visitor) -> bool:
        """Whether a page has said hello."""
        return visitor in self._visitors

    def is_painter(self, page: str) -> bool:
        """Whether the page of this name paints."""
        painter = self._visitors.painter
        return painter is not None and painter.name == page

    def join(self, visitor: Visitor) -> None:
        """Welcome a page: it paints if no other does."""
        self._visitors.join(visitor)
        self._welcome(visitor)
        self._telling.catch_up(visitor)

    def leave(self, visitor: Visitor) -> None:
        """Let a page go; what it has painted is saved."""
        self._visitors.leave(visitor)
        self._easel.save()

    def paint(self, visitor: Visitor, paint: Paint) -> None:
        """Take a stroke of the page that paints, unless it was made on another painting."""
        if self._may_act(visitor) and paint.serial > self.left_behind:
            self._easel.paint(paint.x, paint.y, paint.pixels, paint.serial)
            self._live.paint(paint.x, paint.y, paint.pixels, paint.serial)
            self._show_readers_soon()

    async def grant(self, visitor: Visitor, wish: Wish) -> None:
        """Do what a page asks for, or say why not."""
        if isinstance(wish, protocol.TakeOver):
            async with self._opening:  # what is painted before it ends could not be kept
                self._visitors.take_over(visitor)
                self._welcome(visitor)
        elif self._may_act(visitor):
            try:
                await self._do(wish)
            except InputError as error:
                visitor.outbox.say(said("problem", {"text": sentence(error)}))
                visitor.outbox.say(said("scene", self._state))  # what it shows is not so

    def replace_painting(self, painting: NDArray[np.uint8], text: str) -> None:
        """Take a painting that was made elsewhere, and tell all pages.

        Parameters
        ----------
        painting : (H, W, 3) uint8
        text : str
            Where it comes from, as a sentence.

        Raises
        ------
        InputError
            If it has another size, as when another scene has been chosen meanwhile, or if the
            painting before it cannot be kept.
        """
        if painting.shape[:2] != self.size:
            raise InputError("the painting stays: it is of a scene of another size now")
        try:
            kept = self._easel.replace(painting)
        except InputError as error:
            raise InputError(f"the painting stays, since it cannot be kept: {error}") from None
        self.left_behind = self._easel.serial
        self._live.replace_painting(self._easel.painting.copy(), self._easel.serial)
        for visitor in self._visitors:
            self._send_painting(visitor)
        self._easel.save()
        text = f"{text} The painting before it is kept as {kept}." if kept else text
        self._visitors.say("notes", {"texts": [text]})

    def watched(self, found: NDArray[np.uint8] | InputError, file: str) -> None:
        """Take what a watched file has become, or tell why not.

        Parameters
        ----------
        found : (H, W, 3) uint8 or InputError
        file : str
        """
        try:
            if isinstance(found, InputError):
                raise found
            self.replace_painting(found, f"The painting is that of {file}.")
        except InputError as error:
            self._problem(sentence(error))

    async def _do(self, wish: Wish) -> None:
        setting, live = self._easel.setting, self._live
        match wish:
            case protocol.Rest():
                live.rest()
                self._easel.save()
            case protocol.Finish():
                live.finish()
            case protocol.Step(operation):
                live.step(operation)
            case protocol.Look(what):
                live.look(what)
            case protocol.Export():
                live.export(self._folder.new_export)
            case protocol.ChooseScene(name):
                await self._open(name, setting.layers.get(name, ()))
            case protocol.Layers(names):
                await self._open(setting.scene, names)
            case protocol.Turn(step, restylize):
                if step >= self._scene.steps:
                    raise InputError(f"the scene has {self._scene.steps} steps, from 0")
                live.turn(step, warm=True, restylize=restylize)
                self._set(step=step)
            case protocol.SetSeed(value):
                live.set_seed(value)
                self._set(seed=value)
            case protocol.SetParameters(values):
                live.set_parameters(values)
                self._set(parameters={**setting.parameters, **values})
            case protocol.SetWeights(values):
                live.set_weights(values)
                self._set(weights={**setting.weights, **values})

    async def _open(self, name: str, picked: Sequence[str]) -> None:
        """Open a scene, or the same one with other layers."""
        async with self._opening:
            await self._change_scene(name, picked)

    async def _change_scene(self, name: str, picked: Sequence[str]) -> None:
        offer = self._shelf.offer(name)
        scene = await asyncio.to_thread(offer.read, picked)
        layers = {**self._easel.setting.layers, name: list(picked)}
        if offer.size == self.size:
            self._live.choose_scene(scene)
            self._scene = scene
            self._set(scene=name, step=0, layers=layers)
            self._visitors.say("scene", self._state)
            return
        saved = await asyncio.to_thread(self._painting_of, offer, scene)
        self._easel.close()  # in no thread, so that nothing is painted meanwhile
        setting = self._easel.setting
        saved = replace(saved, setting=replace(setting, serial=setting.serial + LEAP))
        self._live.choose_scene(scene, saved.painting.copy(), saved.setting.serial)
        self._scene, self._easel = scene, self._new_easel(offer, saved)
        self.left_behind = self._easel.serial
        self._set(scene=name, step=0, layers=layers)
        for visitor in self._visitors:
            self._welcome(visitor)

    def _painting_of(self, offer: Offer, scene: Scene) -> Saved:
        """The painting of a source of another size.

        Raises
        ------
        InputError
            If it cannot be had.
        """
        saved = folder_of(offer, self._shelf, self._folder).load(offer.size)
        if saved is None:
            painting = offer.rendering()
            saved = Saved(painting, painting, Setting())
        check_painting(saved.painting, scene)
        return saved

    def _new_easel(self, offer: Offer, saved: Saved) -> Easel:
        folder = folder_of(offer, self._shelf, self._folder)
        return Easel(folder, saved, self.from_thread(self._tell_saved))

    def _set(self, **changes: Any) -> None:
        """Change the setting; readers are told all."""
        self._easel.set(replace(self._easel.setting, **changes))
        self._easel.save()
        for reader in self._visitors.readers:
            self._welcome(reader)

    @property
    def _state(self) -> dict[str, Any]:
        return panels_of_scene(self.offer, self._easel.setting)

    def _restore(self) -> None:
        """Bring back what was set; what a later version does not know is left out and told."""
        setting, known = self._easel.setting, self._scene.buffers
        weights = {name: weight for name, weight in setting.weights.items() if name in known}
        for name, restore, values in (
            ("parameters", self._live.set_parameters, setting.parameters),
            ("weights", self._live.set_weights, weights),
        ):
            try:
                if values:
                    restore(values)
            except InputError as error:
                self._notes.append(f"The {name} of last time are left out: {sentence(error)}")
                self._easel.set(replace(self._easel.setting, **{name: {}}))
        if setting.step:
            self._live.turn(setting.step, warm=False)

    def _welcome(self, visitor: Visitor) -> None:
        """Send a page all that it shows, its painting included."""
        panels, notes = self._panels, self._notes
        told = welcome(self._easel, self._shelf, self._scene, panels, notes)
        told |= {"role": self._visitors.role(visitor), "page": visitor.name}
        visitor.outbox.say(said("welcome", told))
        visitor.outbox.show("beginning", painting_bytes(self._easel.beginning, 0))
        if self._easel.serial:
            self._send_painting(visitor)

    def _send_painting(self, visitor: Visitor) -> None:
        visitor.outbox.show("painting", painting_bytes(self._easel.painting, self._easel.serial))

    def _may_act(self, visitor: Visitor) -> bool:
        """Whether a page paints; one that does not is told so."""
        may = visitor is self._visitors.painter
        if not may:
            visitor.outbox.say(said("problem", {"text": LOOKS_ON}))
        return may

    def _show_readers_soon(self) -> None:
        if self._visitors.readers and not self._readers_are_due:
            self._readers_are_due = True
            self._loop.call_later(READERS_WAIT, self._show_readers)

    def _show_readers(self) -> None:
        self._readers_are_due = False
        for reader in self._visitors.readers:
            self._send_painting(reader)

    def _problem(self, text: str) -> None:
        """Tell all pages what went wrong."""
        self._visitors.say("problem", {"text": text})

    def _tell_saved(self, error: InputError | None) -> None:
        if error:
            self._problem(f"The painting is not saved: {sentence(error)}")
        else:
            text = f"Saved in {self._easel.folder.folder} at {datetime.now():%H:%M:%S}."
            self._visitors.say("saved", {"text": text})
