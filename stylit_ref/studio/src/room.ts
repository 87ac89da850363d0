// The room of the page: what is open, and what is folded away.

import { byId } from "./elements.js";

/** Narrower windows have no room for panels beside the pictures. */
const WIDE = matchMedia("(min-width: 1100px)");

function folding(button: HTMLElement, name: string): (isOpen: boolean) => void {
  const fold = (isOpen: boolean) => {
    document.body.classList.toggle(name, isOpen);
    button.ariaExpanded = String(isOpen);
  };
  button.onclick = () => fold(!document.body.classList.contains(name));
  return fold;
}

export function room(): { togglePanels(): void; showHelp(): void } {
  const foldPanels = folding(byId("panels-open"), "shows-panels");
  foldPanels(WIDE.matches);
  WIDE.addEventListener("change", () => foldPanels(WIDE.matches));
  byId("panels-close").onclick = () => {
    foldPanels(false);
    byId("panels-open").focus();
  };
  folding(byId("brush-open"), "shows-brush");
  const help = byId<HTMLDialogElement>("help-dialog");
  byId("help").onclick = () => help.showModal();
  for (const close of document.querySelectorAll<HTMLButtonElement>("[data-close]"))
    close.onclick = () => close.closest("dialog")?.close();
  const views = byId<HTMLDialogElement>("views-dialog");
  byId("views-open").onclick = () => {
    byId<HTMLIFrameElement>("views").src = "/views/";
    views.showModal();
  };
  return { togglePanels: () => byId("panels-open").click(), showHelp: () => help.showModal() };
}
