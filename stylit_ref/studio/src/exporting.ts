// The export: files, and the commands that make the same bytes again.

import type { Connection } from "./connection.js";
import { byId, made } from "./elements.js";
import type { Exported } from "./protocol.js";

export class Exporting {
  private readonly dialog = byId<HTMLDialogElement>("export-dialog");
  private readonly state = byId("export-state");

  constructor(connection: Connection, open: HTMLElement) {
    open.onclick = () => {
      byId("export-done").hidden = true;
      const isAsked = connection.ask({ do: "export" });
      this.state.textContent = isAsked ? "The files are being written." : "Nothing can be exported while there is no connection.";
      this.dialog.showModal();
    };
  }

  tell({ folder, files, commands }: Exported): void {
    this.state.textContent = `The files lie in ${folder}.`;
    byId("export-files").replaceChildren(
      ...files.map((file) => {
        const name = file.split(/[\\/]/).at(-1) as string;
        return made("li", {}, made("a", { href: `/export/${encodeURIComponent(name)}`, download: name, textContent: name }));
      }),
    );
    byId("export-commands").replaceChildren(...commands.map(commandOf));
    byId("export-done").hidden = false;
  }

  fail(text: string): void {
    if (this.dialog.open && byId("export-done").hidden) this.state.textContent = text;
  }
}

function commandOf(command: string): HTMLElement {
  const text = made("code", { textContent: command, tabIndex: 0 });
  const copy = made("button", { type: "button", className: "small", textContent: "Copy" });
  copy.onclick = async () => {
    try {
      await navigator.clipboard.writeText(command);
      copy.textContent = "Copied";
    } catch {
      getSelection()?.selectAllChildren(text);
      copy.textContent = "Selected";
    }
  };
  return made("li", { className: "command" }, text, copy);
}
