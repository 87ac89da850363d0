// Hands on the painting: they paint, pick colours, or move the sheet.

import type { Artist } from "./artist.js";
import type { Drag } from "./hands.js";
import { coalesced, sampleOf, type Sample } from "./pen.js";
import type { Picker } from "./picker.js";
import type { Settings } from "./settings.js";
import type { Tip } from "./tip.js";
import type { Viewport } from "./viewport.js";

export function easel(viewport: Viewport, artist: Artist, picker: Picker, settings: Settings, tip: Tip): Drag {
  let picks = false;
  const placeOf = (event: PointerEvent) => viewport.placeAt(event.clientX, event.clientY);
  const sample = (event: PointerEvent): Sample => sampleOf(event, placeOf(event));
  viewport.pane.addEventListener("pointermove", (event) => tip.follow(event));
  viewport.pane.addEventListener("pointerleave", () => tip.hide());
  return {
    begin(event) {
      const { tool } = settings.chosen;
      picks = tool === "picker" || event.altKey;
      if (picks) picker.pick(...placeOf(event));
      else if (tool === "hand" || !artist.mayPaint) return false;
      else artist.begin(sample(event), event.timeStamp);
      return true;
    },
    move(event) {
      if (picks) picker.pick(...placeOf(event));
      else artist.move(coalesced(event).map(sample), event.timeStamp);
    },
    end(event) {
      if (picks) picker.done();
      else artist.end(event.timeStamp);
    },
    cancel: () => artist.cancel(),
  };
}
