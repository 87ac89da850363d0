// Draw with an engine of the page, with places and buffers that a test gives.
(given) => {
  const { width, height, places } = given;
  const pixels = width * height;
  const rgba = (list) => list && Uint8Array.from(list);
  const kept = { voted: rgba(given.voted), shifted: given.shifted && Uint16Array.from(given.shifted) };

  const engine = window.stylitViewer.engines.make({
    width, height, patchRadius: given.radius, reach: 1, mesh: null, hasPoints: false, slots: 4,
    style: { ...given.style, rgba: rgba(given.style.rgba) },
  });
  ({ webgl: prepareWebgl, script: prepareScript })[engine.name]();
  given.views.forEach(({ field, picture }, slot) =>
    engine.keep(slot, { field: field && Uint16Array.from(field), rgba: rgba(picture), points: null, lens: null }),
  );
  const around = given.weights.map((weight, slot) => ({ slot, linear: weight, fading: weight, lens: null }));
  engine.draw({ mode: given.mode, lens: null, around, step: 1 });
  return [...engine.read(given.buffer)];

  /** Places are numbers of pixels; their complements where the view does not show the point. */
  function prepareScript() {
    engine.places = () => places.map((each) => Int32Array.from(each));
    if (kept.voted) engine.voted = unwritable(kept.voted);
    if (kept.shifted) engine.fields.shifted = unwritable(kept.shifted);
  }

  function prepareWebgl() {
    const { context, buffers, fill } = engine;
    const motion = [new Int16Array(4 * pixels), new Int16Array(4 * pixels)];
    const hidden = new Uint8Array(pixels);
    (places ?? []).forEach((each, k) =>
      each.forEach((place, p) => {
        const at = place < 0 ? ~place : place;
        if (place < 0) hidden[p] |= 1 << k;
        motion[k >> 1][4 * p + 2 * (k & 1)] = (at % width) - (p % width);
        motion[k >> 1][4 * p + 2 * (k & 1) + 1] = Math.floor(at / width) - Math.floor(p / width);
      }),
    );
    engine.findMotion = () => {
      const { motion01, motion23, hidden: bits } = buffers;
      context.set(motion01, width, height, motion[0]);
      context.set(motion23, width, height, motion[1]);
      context.set(bits, width, height, hidden);
      return { motion01, motion23, hidden: bits, size: [width, height], step: 1, bits: 0 };
    };
    engine.fill = (program, values, into) => {
      if (kept[into]) context.set(buffers[into], width, height, kept[into]);
      else fill.call(engine, program, values, into);
    };
  }

  /** An array that passes may read; what they write is forgotten. */
  function unwritable(array) {
    return new Proxy(array, { get: (it, key) => it[key], set: () => true });
  }
}
