// The room of the page: what is open, and what is folded away.

import { byId } from "./elements.js";
import { Popup } from "./popup.js";

/** Narrower windows have no room for panels beside the pictures. */
const WIDE = matchMedia("(min-width: 1100px)");

export function room(): { togglePanels(): void; showHelp(): void } {
  const button = byId("panels-open");
  const shows = (name: string) => (isShown: boolean) => void document.body.classList.toggle(name, isShown);
  const showPanels = (areShown: boolean) => {
    shows("shows-panels")(areShown);
    button.ariaExpanded = String(areShown);
  };
  showPanels(WIDE.matches);
  WIDE.addEventListener("change", () => showPanels(WIDE.matches));
  button.onclick = () => showPanels(button.ariaExpanded !== "true");
  byId("panels-close").onclick = () => {
    showPanels(false);
    button.focus();
  };
  new Popup(byId("brush-open"), byId("brush"), shows("shows-brush"));
  const help = byId<HTMLDialogElement>("help-dialog");
  byId("help").onclick = () => help.showModal();
  for (const close of document.querySelectorAll<HTMLButtonElement>("[data-close]"))
    close.onclick = () => close.closest("dialog")?.close();
  const views = byId<HTMLDialogElement>("views-dialog");
  const frame = byId<HTMLIFrameElement>("views");
  byId("views-open").onclick = () => {
    views.showModal();
    if (frame.src) return;
    frame.src = "/views/";
    byId("views-wait").hidden = false;
    frame.onload = () => (byId("views-wait").hidden = true);
  };
  return { togglePanels: () => button.click(), showHelp: () => help.showModal() };
}
