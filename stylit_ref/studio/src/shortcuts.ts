// Keys that work anywhere on the page, unless something takes letters.

import { byId, takesLetters } from "./elements.js";

const KEY = "stylit-studio-letters";

/** What keys do, by what is typed; letters with Shift are capital. */
export function shortcuts(actions: Record<string, () => void>, undo: () => void, redo: () => void): void {
  const letters = byId<HTMLInputElement>("letters");
  letters.checked = localStorage.getItem(KEY) !== "off";
  letters.onchange = () => localStorage.setItem(KEY, letters.checked ? "on" : "off");
  addEventListener("keydown", (event) => {
    if (event.altKey || event.defaultPrevented || takesLetters(event.target)) return;
    if (event.ctrlKey || event.metaKey) {
      const key = event.key.toLowerCase();
      if (key === "z") (event.shiftKey ? redo : undo)();
      else if (key === "y") redo();
      else return;
    } else {
      const action = letters.checked && actions[event.key];
      if (!action) return;
      action();
    }
    event.preventDefault();
  });
}
