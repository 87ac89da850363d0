// Where an engine of the page finds the pixels of what it is told that it sees, in one view.
(given) => {
  const { width, height, faces, inverse, beside, lens, viewLens } = given;
  const pixels = width * height;
  const engine = window.stylitViewer.engines.make({
    width, height, patchRadius: 0, reach: 1, mesh: null, hasPoints: true, slots: 4,
    style: { width: 1, height: 1, rgba: new Uint8Array(4) },
  });
  engine.keep(0, { field: new Uint16Array(2 * pixels), rgba: null, points: null, lens: null });
  const viewFaces = Uint16Array.from(given.viewFaces);
  const moment = { mode: "nnf", lens, around: [{ slot: 0, linear: 1, fading: 1, lens: viewLens }], step: 1 };
  return engine.name === "webgl" ? byWebgl() : byScript();

  function byScript() {
    const surface = { width, height, faces: Uint16Array.from(faces), inverse: Float32Array.from(inverse) };
    engine.see = () => [surface, Int32Array.from(beside)];
    engine.kept[0].labels = viewFaces;
    engine.draw(moment);
    return [...engine.read("places")];
  }

  function byWebgl() {
    const { context, buffers } = engine;
    const bits = new Uint32Array(Float32Array.from(inverse).buffer);
    const column = (p) => p % width;
    const row = (p) => Math.floor(p / width);
    const interleaved = (numbers, one, other) => numbers.from({ length: 2 * pixels }, (_, i) => (i & 1 ? other : one)(i >> 1));
    engine.see = () => {
      context.set(buffers.surface, width, height, interleaved(Uint32Array, (p) => faces[p], (p) => bits[p]));
      const [across, down] = [column, row].map((each) => (p) => each(beside[p]));
      context.set(buffers.beside, width, height, interleaved(Uint16Array, across, down));
    };
    context.set(buffers.labels, width, height, viewFaces);
    engine.draw(moment);
    const [motion, hidden] = [engine.read("motion01"), engine.read("hidden")];
    return faces.map((_, p) => {
      const [x, y] = [column(p) + motion[4 * p], row(p) + motion[4 * p + 1]];
      const [nearX, nearY] = [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1)];
      const place = nearY * width + nearX;
      return hidden[p] & 1 || nearX !== x || nearY !== y ? ~place : place;
    });
  }
}
