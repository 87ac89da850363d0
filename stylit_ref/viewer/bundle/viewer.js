"use strict";
(() => {
  // src/controls.ts
  var STEP = 0.05;
  var WHOLE_TURN = 180;
  var GLIDE = 180;
  var ARROWS = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1]
  };
  function control(canvas, grid, turned) {
    const prefersStillness = matchMedia("(prefers-reduced-motion: reduce)");
    let speed = [0, 0];
    let before = 0;
    let finger = null;
    canvas.addEventListener("pointerdown", (event) => {
      if (finger !== null || event.button !== 0) return;
      finger = event.pointerId;
      canvas.setPointerCapture(finger);
      speed = [0, 0];
      before = event.timeStamp;
      last = [event.clientX, event.clientY];
    });
    let last = [0, 0];
    canvas.addEventListener("pointermove", (event) => {
      if (event.pointerId !== finger) return;
      const scale = scaleOf(canvas, grid);
      const right = -(event.clientX - last[0]) * scale[0];
      const up = (event.clientY - last[1]) * scale[1];
      const time = Math.max(event.timeStamp - before, 1);
      last = [event.clientX, event.clientY];
      before = event.timeStamp;
      speed = [right / time, up / time];
      turned.by(right, up);
    });
    const release = (event) => {
      if (event.pointerId !== finger) return;
      finger = null;
      if (!prefersStillness.matches && event.timeStamp - before < 50) requestAnimationFrame(glide);
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    canvas.addEventListener("lostpointercapture", release);
    const glide = (now) => {
      if (finger !== null || Math.hypot(...speed) < 1e-3) return;
      const time = Math.min(Math.max(now - before, 0), 50);
      before = now;
      turned.by(speed[0] * time, speed[1] * time);
      const kept = Math.exp(-time / GLIDE);
      speed = [speed[0] * kept, speed[1] * kept];
      requestAnimationFrame(glide);
    };
    canvas.addEventListener("keydown", (event) => {
      if (event.altKey || event.ctrlKey || event.metaKey) return;
      const arrow = ARROWS[event.key];
      if (event.key === "Home") turned.home();
      else if (arrow) {
        const steps = event.shiftKey ? 1 : STEP;
        const [right, up] = grid.spacing;
        turned.by(arrow[0] * steps * right, arrow[1] * steps * up);
      } else return;
      speed = [0, 0];
      event.preventDefault();
    });
  }
  function scaleOf(canvas, grid) {
    const { clientWidth, clientHeight } = canvas;
    const [right, up] = grid.reach.map((reach) => Math.min(2 * reach, WHOLE_TURN));
    return [right / clientWidth, up / clientHeight];
  }

  // src/bitmaps.ts
  var READERS = [byCanvas, byTexture];
  function byCanvas(bitmap) {
    const { width, height } = bitmap;
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    const context = canvas.getContext("2d", { willReadFrequently: true, colorSpace: "srgb" });
    if (!context) return null;
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, width, height).data;
  }
  function byTexture(bitmap) {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return null;
    const { width, height } = bitmap;
    const pixels = new Uint8Array(4 * width * height);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8UI, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE, bitmap);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    const texture = gl.getParameter(gl.TEXTURE_BINDING_2D);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE, pixels);
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return pixels;
  }

  // src/page_data.ts
  var FORMAT = 1;
  var PageError = class extends Error {
  };
  function readPageData() {
    const text = document.getElementById("stylit-data")?.textContent;
    if (!text) throw new PageError("This page is incomplete: it holds no drawing. Ask for it again.");
    let data;
    try {
      data = JSON.parse(text);
    } catch {
      throw new PageError("This page is damaged: its table of contents cannot be read. Ask for it again.");
    }
    if (data.format !== FORMAT)
      throw new PageError(`This page holds data of format ${data.format}, and its program reads ${FORMAT}.`);
    return data;
  }

  // src/decode.ts
  async function decode(piece, source) {
    if (typeof DecompressionStream === "undefined" || typeof createImageBitmap === "undefined")
      throw new PageError("This browser is too old for the page. Open it in a current one.");
    const packed = await source(piece.name);
    try {
      const attempts = piece.coding === "webp" ? ofWebp(packed) : [inflate(packed)];
      for await (const bytes of attempts) if (bytes.length === piece.bytes && crc32(bytes) === piece.sum) return bytes;
    } catch {
    }
    throw damaged(piece);
  }
  function damaged(piece) {
    return new PageError(`This page is damaged: ${piece.name} does not hold what was exported. Ask for it again.`);
  }
  async function inflate(packed) {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }
  async function* ofWebp(packed) {
    const blob = new Blob([packed], { type: "image/webp" });
    const bitmap = await createImageBitmap(blob, { premultiplyAlpha: "none", colorSpaceConversion: "none" });
    for (const read of READERS) {
      const pixels = read(bitmap);
      if (pixels) yield withoutAlpha(pixels);
    }
  }
  function withoutAlpha(pixels) {
    const bytes = new Uint8Array(pixels.length / 4 * 3);
    for (let from = 0, to = 0; from < pixels.length; from += 4, to += 3) {
      bytes[to] = pixels[from];
      bytes[to + 1] = pixels[from + 1];
      bytes[to + 2] = pixels[from + 2];
    }
    return bytes;
  }
  var TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let bit = 0; bit < 8; bit++) n = n & 1 ? n >>> 1 ^ 3988292384 : n >>> 1;
    return n;
  });
  function crc32(bytes) {
    let sum = 4294967295;
    for (let i = 0; i < bytes.length; i++) sum = TABLE[(sum ^ bytes[i]) & 255] ^ sum >>> 8;
    return (sum ^ 4294967295) >>> 0;
  }

  // src/engine.ts
  var SKY = 65535;
  var SLOTS = 16;

  // src/vectors.ts
  var dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  var minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  function combine(...terms) {
    const sum = (i) => terms.reduce((total, [factor, vector]) => total + factor * vector[i], 0);
    return [sum(0), sum(1), sum(2)];
  }
  var cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0]
  ];
  function unit(a) {
    const length = Math.hypot(a[0], a[1], a[2]);
    return [a[0] / length, a[1] / length, a[2] / length];
  }

  // src/camera.ts
  var RADIANS = Math.PI / 180;
  var NEAR = 0.01;
  function lensOf(camera, width, height) {
    const eye = camera.origin;
    const away = minus(camera.target, eye);
    const forward = unit(away);
    const rightward = unit(cross(forward, camera.up));
    const upward = cross(rightward, forward);
    const focal = height / (2 * Math.tan(camera.fieldOfView * RADIANS / 2));
    const focalAcross = focal / camera.pixelAspect;
    const middle = (width - 1) / 2 - camera.shift[0] * height / camera.pixelAspect;
    const centre = (height - 1) / 2 + camera.shift[1] * height;
    const row = (axis) => [...axis, -dot(axis, eye)];
    return {
      eye,
      near: NEAR * Math.hypot(...away),
      across: row(combine([focalAcross, rightward], [middle, forward])),
      down: row(combine([-focal, upward], [centre, forward])),
      depth: row(forward),
      right: combine([1 / focalAcross, rightward]),
      below: combine([-1 / focal, upward]),
      corner: combine([1, forward], [-middle / focalAcross, rightward], [centre / focal, upward])
    };
  }
  function onOrbit(target, up, azimuth, elevation, distance) {
    const axis = unit(up);
    const inFront = Math.abs(axis[1]) < Math.abs(axis[2]) ? [0, -1, 0] : [0, 0, 1];
    const front = unit(combine([1, inFront], [-dot(inFront, axis), axis]));
    const [a, e] = [azimuth * RADIANS, elevation * RADIANS];
    const level = combine([Math.cos(a), front], [Math.sin(a), cross(axis, front)]);
    return combine([1, target], [distance * Math.cos(e), level], [distance * Math.sin(e), axis]);
  }
  function transferOf(from, to) {
    return [to.across, to.down, to.depth].map((row) => [
      dot(row, from.right),
      dot(row, from.below),
      dot(row, from.corner),
      dot(row, from.eye) + row[3]
    ]);
  }

  // src/grid.ts
  var ONE = 256;
  var WHOLE = ONE * ONE;
  var Grid = class {
    data;
    constructor(data) {
      this.data = data;
    }
    get hasCameras() {
      return this.data.views.every((view) => view.camera !== null);
    }
    /** What a grid reaches to the right and upwards, from the middle; a ring has no end. */
    get reach() {
      return [reachOf(this.data.columns), reachOf(this.data.rows)];
    }
    /** The mean way from a view to the next. */
    get spacing() {
      return [spacingOf(this.data.columns), spacingOf(this.data.rows)];
    }
    /** The nearest place that the grid has. */
    within(place) {
      const { columns, rows } = this.data;
      return [held(place[0], columns), held(place[1], rows)];
    }
    /** The views around a place, the closest first; of those as close, by row and column. */
    around(place) {
      const { columns, rows, fadeBand } = this.data;
      const [across, upwards] = [between(place[0], columns), between(place[1], rows)];
      const found = sides(upwards, fadeBand).flatMap(
        (row) => sides(across, fadeBand).map((column) => ({
          view: row.number * columns.positions.length + column.number,
          linear: row.linear * column.linear,
          fading: row.fading * column.fading,
          distance: (across.at - column.at) ** 2 + (upwards.at - row.at) ** 2
        }))
      );
      return found.sort((a, b) => a.distance - b.distance || a.view - b.view);
    }
    /** The views beyond those around, which a next turn may need: with them 16 at most. */
    beyond(place) {
      const { columns, rows } = this.data;
      const [across, upwards] = [beside(between(place[0], columns), columns), beside(between(place[1], rows), rows)];
      const around = this.around(place).map((neighbour) => neighbour.view);
      const all = upwards.flatMap((row) => across.map((column) => row * columns.positions.length + column));
      return all.filter((view) => !around.includes(view));
    }
    /** The camera at a place. Around a target it stays on its orbit; whatever else differs is blended. */
    camera(place) {
      const { columns, rows, views } = this.data;
      const [across, upwards] = [between(place[0], columns), between(place[1], rows)];
      const at = (row, column) => views[row * columns.positions.length + column].camera;
      const [low, high] = [upwards.low, upwards.high].map(
        (row) => blended(at(row, across.low), at(row, across.high), share(across))
      );
      const camera = blended(low, high, share(upwards));
      if (columns.unit === "steps") return camera;
      const { target, up, turn, rise, distance } = camera;
      return { ...camera, origin: onOrbit(target, up, across.at + turn, upwards.at + rise, distance) };
    }
  };
  function reachOf(axis) {
    const { positions, isRing } = axis;
    return isRing ? Infinity : (positions[positions.length - 1] - positions[0]) / 2;
  }
  function spacingOf(axis) {
    const count = axis.positions.length;
    return axis.isRing ? 360 / count : count > 1 ? 2 * reachOf(axis) / (count - 1) : 1;
  }
  function held(place, axis) {
    const reach = reachOf(axis);
    return axis.isRing ? (place % 360 + 360) % 360 : Math.min(Math.max(place, -reach), reach);
  }
  function beside({ low, high }, { positions, isRing }) {
    const count = positions.length;
    const four2 = [low - 1, low, high, high + 1];
    const there = isRing ? four2.map((each) => (each + count) % count) : four2.filter((each) => each >= 0 && each < count);
    return [...new Set(there)];
  }
  function between(place, axis) {
    const first = axis.positions[0];
    const count = axis.positions.length;
    const positions = axis.isRing ? [...axis.positions, first + 360] : axis.positions;
    const at = axis.isRing ? first + (place % 360 + 360) % 360 : place + (first + positions[count - 1]) / 2;
    if (count === 1) return { low: 0, high: 0, at, lowAt: first, highAt: first };
    let low = 0;
    while (low < positions.length - 2 && at >= positions[low + 1]) low++;
    return { low, high: (low + 1) % count, at, lowAt: positions[low], highAt: positions[low + 1] };
  }
  function sides(between2, band) {
    const { low, high, lowAt, highAt } = between2;
    if (low === high) return [{ number: low, at: lowAt, linear: ONE, fading: ONE }];
    const linear = Math.floor(share(between2) * ONE + 0.5);
    const fading = fadingWeight(between2, band);
    return [
      { number: low, at: lowAt, linear: ONE - linear, fading: ONE - fading },
      { number: high, at: highAt, linear, fading }
    ];
  }
  function fadingWeight({ at, lowAt, highAt }, band) {
    const middle = (lowAt + highAt) / 2;
    const width = band * (highAt - lowAt);
    if (width === 0) return at > middle ? ONE : 0;
    return Math.min(Math.max(Math.floor((0.5 + (at - middle) / width) * ONE + 0.5), 0), ONE);
  }
  function share({ at, lowAt, highAt }) {
    return highAt === lowAt ? 0 : (at - lowAt) / (highAt - lowAt);
  }
  function blended(a, b, along) {
    const mix2 = (p, q) => p + (q - p) * along;
    const mixAll = (p, q) => p.map((each, i) => mix2(each, q[i]));
    return {
      origin: mixAll(a.origin, b.origin),
      target: mixAll(a.target, b.target),
      up: mixAll(a.up, b.up),
      fieldOfView: mix2(a.fieldOfView, b.fieldOfView),
      shift: mixAll(a.shift, b.shift),
      pixelAspect: mix2(a.pixelAspect, b.pixelAspect),
      turn: mix2(a.turn, b.turn),
      rise: mix2(a.rise, b.rise),
      distance: mix2(a.distance, b.distance)
    };
  }

  // src/fading.ts
  function framesOf({ mode, around }) {
    const all = around.map((_, k) => k);
    if (mode !== "fade") return [{ order: all, weight: WHOLE }];
    return all.filter((k) => around[k].fading > 0).map((k) => ({ order: [k, ...all.filter((other) => other !== k)], weight: around[k].fading }));
  }
  function shiftedWeights({ mode, around }) {
    return around.map((view, k) => mode === "blend" ? view.linear : k === 0 ? WHOLE : 0);
  }

  // src/script/limited_search.ts
  function limitedSearch(places, fields, shifted, picture, stage, found) {
    const { width, height, patchRadius: radius } = stage;
    const { width: stride, rgba } = stage.style;
    const difference = (y, x, sourceY, sourceX, limit) => {
      let sum = 0;
      for (let dy = -radius; dy <= radius && sum < limit; dy++) {
        const row = Math.min(Math.max(y + dy, 0), height - 1) * width;
        let source = 4 * ((sourceY + dy) * stride + sourceX - radius);
        for (let dx = -radius; dx <= radius; dx++, source += 4) {
          const at = 4 * (row + Math.min(Math.max(x + dx, 0), width - 1));
          const red = rgba[source] - picture[at];
          const green = rgba[source + 1] - picture[at + 1];
          const blue = rgba[source + 2] - picture[at + 2];
          sum += red * red + green * green + blue * blue;
        }
      }
      return sum;
    };
    for (let y = 0, p = 0; y < height; y++)
      for (let x = 0; x < width; x++, p++) {
        let [bestY, bestX] = [shifted[2 * p], shifted[2 * p + 1]];
        let best = -1;
        for (let k = 0; k < places.length; k++) {
          const place = places[k][p];
          if (place < 0) continue;
          const [nextY, nextX] = [fields[k][2 * place], fields[k][2 * place + 1]];
          if (nextY === bestY && nextX === bestX) continue;
          if (best < 0) best = difference(y, x, bestY, bestX, Infinity);
          const next = difference(y, x, nextY, nextX, best);
          if (next < best) [best, bestY, bestX] = [next, nextY, nextX];
        }
        found[2 * p] = bestY;
        found[2 * p + 1] = bestX;
      }
  }

  // src/script/shift.ts
  function shift(places, fields, shifted) {
    for (let p = 0; p < places[0].length; p++) {
      const [k, place] = chosen(places, p);
      shifted[2 * p] = fields[k][2 * place];
      shifted[2 * p + 1] = fields[k][2 * place + 1];
    }
  }
  function chosen(places, p) {
    for (let k = 0; k < places.length; k++) if (places[k][p] >= 0) return [k, places[k][p]];
    return [0, ~places[0][p]];
  }

  // src/script/mix.ts
  function mix(pictures, weights, mixed2) {
    const whole = weights.reduce((sum, each) => sum + each, 0);
    for (let i = 0; i < mixed2.length; i++) {
      let sum = 0;
      for (let k = 0; k < pictures.length; k++) sum += weights[k] * pictures[k][i];
      mixed2[i] = Math.floor((2 * sum + whole) / (2 * whole));
    }
  }
  function mixShifted(places, pictures, weights, mixed2) {
    for (let p = 0; p < places[0].length; p++) {
      const isHeard = (k) => places[k][p] >= 0 && weights[k] > 0;
      let whole = 0;
      for (let k = 0; k < places.length; k++) if (isHeard(k)) whole += weights[k];
      const [first, place] = chosen(places, p);
      for (let c = 0; c < 4; c++) {
        let sum = 0;
        for (let k = 0; k < places.length; k++) if (isHeard(k)) sum += weights[k] * pictures[k][4 * places[k][p] + c];
        mixed2[4 * p + c] = whole ? Math.floor((2 * sum + whole) / (2 * whole)) : pictures[first][4 * place + c];
      }
    }
  }

  // src/script/motion.ts
  function placesIn(labels, from, to, surface, near, step, width, height) {
    const [across, down, depth] = transferOf(from, to);
    const places = new Int32Array(width * height);
    for (let y = 0, p = 0; y < height; y++)
      for (let x = 0; x < width; x++, p++) {
        const q = near[Math.floor(y / step) * surface.width + Math.floor(x / step)];
        const v = surface.inverse[q];
        let [dx, dy] = [0, 0];
        let isNear = true;
        if (v > 0) {
          const px = (q % surface.width + 0.5) * step - 0.5;
          const py = (Math.floor(q / surface.width) + 0.5) * step - 0.5;
          const z = depth[0] * px + depth[1] * py + depth[2] + depth[3] * v;
          dx = (across[0] * px + across[1] * py + across[2] + across[3] * v) / z - px;
          dy = (down[0] * px + down[1] * py + down[2] + down[3] * v) / z - py;
          isNear = z > 0 && Math.abs(dx) <= width && Math.abs(dy) <= height;
          if (!isNear) dx = dy = 0;
        }
        const [column, row] = [Math.floor(x + dx + 0.5), Math.floor(y + dy + 0.5)];
        const [insideX, insideY] = [Math.min(Math.max(column, 0), width - 1), Math.min(Math.max(row, 0), height - 1)];
        const place = insideY * width + insideX;
        const isShown = isNear && insideX === column && insideY === row && labels[place] === surface.faces[q];
        places[p] = isShown ? place : ~place;
      }
    return places;
  }

  // src/script/raster.ts
  function raster(mesh, lens, pictureWidth, pictureHeight, step) {
    const [width, height] = [pictureWidth, pictureHeight].map((side) => Math.ceil(side / step));
    const surface = {
      width,
      height,
      faces: new Uint16Array(width * height).fill(SKY),
      inverse: new Float32Array(width * height)
    };
    for (let t = 0; t < mesh.faces.length; t++) {
      const plane = mesh.planes.subarray(4 * t, 4 * t + 4);
      const distance = -(dot(plane, lens.eye) + plane[3]);
      const polygon = seen(mesh.corners.subarray(9 * t, 9 * t + 9), lens, step);
      if (polygon.length < 3 || distance === 0) continue;
      const depth = [lens.right, lens.below, lens.corner].map((each) => dot(plane, each) / distance);
      fill(surface, polygon, mesh.faces[t], depth, step);
    }
    return surface;
  }
  function seen(corners, lens, step) {
    const rows = [lens.across, lens.down, lens.depth];
    const ends = [0, 3, 6].map((from) => {
      const point = corners.subarray(from, from + 3);
      return rows.map((row) => dot(row, point) + row[3]);
    });
    const polygon = [];
    const add = (end) => polygon.push([(end[0] / end[2] + 0.5) / step - 0.5, (end[1] / end[2] + 0.5) / step - 0.5]);
    ends.forEach((one, k) => {
      const other = ends[(k + 1) % 3];
      if (one[2] > lens.near) add(one);
      if (one[2] > lens.near !== other[2] > lens.near) {
        const along = (lens.near - one[2]) / (other[2] - one[2]);
        add(one.map((each, i) => each + along * (other[i] - each)));
      }
    });
    return polygon;
  }
  function fill(surface, polygon, face, [a, b, c], step) {
    const { width, height, faces, inverse } = surface;
    const down = polygon.map((point) => point[1]);
    const first = Math.max(Math.ceil(Math.min(...down)), 0);
    const last = Math.min(Math.floor(Math.max(...down)), height - 1);
    for (let y = first; y <= last; y++) {
      let [left, right] = [Infinity, -Infinity];
      for (let k = 0; k < polygon.length; k++) {
        const [x0, y0] = polygon[k];
        const [x1, y1] = polygon[(k + 1) % polygon.length];
        if (y0 === y1 || y < Math.min(y0, y1) || y > Math.max(y0, y1)) continue;
        const x = x0 + (y - y0) * (x1 - x0) / (y1 - y0);
        left = Math.min(left, x);
        right = Math.max(right, x);
      }
      const row = b * ((y + 0.5) * step - 0.5) + c;
      for (let x = Math.max(Math.ceil(left), 0); x <= Math.min(Math.floor(right), width - 1); x++) {
        const depth = Math.fround(a * ((x + 0.5) * step - 0.5) + row);
        if (!(depth > inverse[y * width + x])) continue;
        inverse[y * width + x] = depth;
        faces[y * width + x] = face;
      }
    }
  }

  // src/script/silhouettes.ts
  var isNearer = (inverse, other) => inverse > 1.05 * other;
  function beside2(surface, reach) {
    const { width, height, inverse } = surface;
    const rims = rimsOf(surface);
    const inRows = grownInRows(rims, width, reach);
    const isClose = grownInColumns(inRows, width, height, reach);
    const places = Int32Array.from(inverse, (_, p) => p);
    for (let y = 0, p = 0; y < height; y++)
      for (let x = 0; x < width; x++, p++) {
        if (!isClose[p]) continue;
        let closest = reach * reach + 1;
        let nearest = Infinity;
        for (let row2 = Math.max(y - reach, 0); row2 <= Math.min(y + reach, height - 1); row2++) {
          if (!inRows[row2 * width + x]) continue;
          for (let column2 = Math.max(x - reach, 0); column2 <= Math.min(x + reach, width - 1); column2++) {
            const q = row2 * width + column2;
            if (!rims[q]) continue;
            const away = (row2 - y) ** 2 + (column2 - x) ** 2;
            const wins = away < closest || away === closest && inverse[q] > nearest;
            if (!wins || !isNearer(inverse[q], inverse[p])) continue;
            closest = away;
            nearest = inverse[q];
            places[p] = q;
          }
        }
        if (closest > reach * reach) continue;
        const [rimY, rimX] = [Math.floor(places[p] / width), places[p] % width];
        const [row, column] = [rimY + Math.sign(rimY - y), rimX + Math.sign(rimX - x)];
        const isInside = row >= 0 && row < height && column >= 0 && column < width;
        if (isInside && !isNearer(nearest, inverse[row * width + column])) places[p] = row * width + column;
      }
    return places;
  }
  function rimsOf({ width, height, inverse }) {
    const rims = new Uint8Array(inverse.length);
    const isStep = (x, y, dx, dy) => {
      const at = (k) => {
        const [column, row] = [x + k * dx, y + k * dy];
        return column >= 0 && column < width && row >= 0 && row < height ? inverse[row * width + column] : void 0;
      };
      const [near, far] = [inverse[y * width + x], at(1)];
      const before = at(-1) ?? 2 * near - far;
      const behind = at(2) ?? 2 * far - near;
      return near - far > 2 * Math.min(Math.abs(before - near), Math.abs(far - behind));
    };
    for (let y = 0, p = 0; y < height; y++)
      for (let x = 0; x < width; x++, p++) {
        const near = inverse[p];
        if (y > 0 && isNearer(near, inverse[p - width]) && isStep(x, y, 0, -1)) rims[p] = 1;
        else if (y < height - 1 && isNearer(near, inverse[p + width]) && isStep(x, y, 0, 1)) rims[p] = 1;
        else if (x > 0 && isNearer(near, inverse[p - 1]) && isStep(x, y, -1, 0)) rims[p] = 1;
        else if (x < width - 1 && isNearer(near, inverse[p + 1]) && isStep(x, y, 1, 0)) rims[p] = 1;
      }
    return rims;
  }
  function grownInRows(rims, width, reach) {
    const grown = new Uint8Array(rims.length);
    for (let p = 0; p < rims.length; p++) {
      if (!rims[p]) continue;
      const start2 = p - p % width;
      grown.fill(1, Math.max(p - reach, start2), Math.min(p + reach + 1, start2 + width));
    }
    return grown;
  }
  function grownInColumns(set, width, height, reach) {
    const grown = new Uint8Array(set.length);
    for (let y = 0; y < height; y++)
      for (let row = Math.max(y - reach, 0); row <= Math.min(y + reach, height - 1); row++)
        for (let x = 0; x < width; x++) grown[y * width + x] |= set[row * width + x];
    return grown;
  }

  // src/points.ts
  var SLACK = 0.1;
  function pointsOf(planes, width, height) {
    const pixels = width * height;
    const points = new Uint32Array(2 * pixels);
    for (let y = 0, i = 0; y < height; y++) {
      let [label, slope, bits] = [0, 0, 0];
      for (let x = 0; x < width; x++, i++) {
        const byte = (plane) => planes[plane * pixels + i];
        label = label + (byte(0) | byte(1) << 8) & 65535;
        slope = slope + (byte(2) | byte(3) << 8 | byte(4) << 16 | byte(5) << 24) | 0;
        bits = bits + slope | 0;
        points[2 * i] = label;
        points[2 * i + 1] = bits;
      }
    }
    return points;
  }

  // src/script/splat.ts
  var { floor } = Math;
  function surfaceOf(points, width, height) {
    const bits = new Float32Array(points.buffer);
    const faces = new Uint16Array(width * height);
    const inverse = new Float32Array(width * height);
    for (let p = 0; p < faces.length; p++) {
      faces[p] = points[2 * p];
      inverse[p] = bits[2 * p + 1];
    }
    return { width, height, faces, inverse };
  }
  function splat(views, lens, viewWidth, viewHeight, step) {
    const [width, height] = [viewWidth, viewHeight].map((side) => Math.ceil(side / step));
    const faces = new Uint16Array(width * height).fill(SKY);
    const inverse = new Float32Array(width * height);
    const merits = new Float32Array(width * height);
    for (const { points, lens: from } of views) {
      const [across, down, depth] = transferOf(from, lens);
      const bits = new Float32Array(points.buffer);
      for (let y = 0, p = 0; y < viewHeight; y++)
        for (let x = 0; x < viewWidth; x++, p++) {
          const v = bits[2 * p + 1];
          const z = depth[0] * x + depth[1] * y + depth[2] + depth[3] * v;
          if (!(v > 0 && z > 0)) continue;
          const right = (across[0] * x + across[1] * y + across[2] + across[3] * v) / z + 0.5;
          const below = (down[0] * x + down[1] * y + down[2] + down[3] * v) / z + 0.5;
          const column = floor((floor(right) + 0.5) / step);
          const row = floor((floor(below) + 0.5) / step);
          if (column < 0 || column >= width || row < 0 || row >= height) continue;
          const to = row * width + column;
          const near = Math.fround(v / z);
          const [awayX, awayY] = [right / step - column - 0.5, below / step - row - 0.5];
          const merit = Math.fround(near * (1 - SLACK * (awayX * awayX + awayY * awayY)));
          if (merit <= merits[to]) continue;
          merits[to] = merit;
          inverse[to] = near;
          faces[to] = points[2 * p];
        }
    }
    return filled({ width, height, faces, inverse });
  }
  function filled({ width, height, faces, inverse }) {
    const all = { width, height, faces: faces.slice(), inverse: inverse.slice() };
    for (let y = 0, p = 0; y < height; y++)
      for (let x = 0; x < width; x++, p++) {
        if (faces[p] !== SKY) continue;
        for (const [isInside, d] of [[x > 0 && x < width - 1, 1], [y > 0 && y < height - 1, width]]) {
          if (!isInside || faces[p - d] === SKY || faces[p + d] === SKY) continue;
          const from = inverse[p + d] < inverse[p - d] ? p + d : p - d;
          all.faces[p] = faces[from];
          all.inverse[p] = inverse[from];
          break;
        }
      }
    return all;
  }

  // src/script/vote.ts
  function vote(field, stage, colours) {
    const { width, height, patchRadius: radius } = stage;
    const { width: stride, rgba } = stage.style;
    for (let y = 0, to = 0; y < height; y++) {
      const top = Math.max(y - radius, 0);
      const bottom = Math.min(y + radius, height - 1);
      for (let x = 0; x < width; x++, to += 4) {
        const left = Math.max(x - radius, 0);
        const right = Math.min(x + radius, width - 1);
        let [red, green, blue] = [0, 0, 0];
        for (let row = top; row <= bottom; row++)
          for (let column = left, from = 2 * (row * width + left); column <= right; column++, from += 2) {
            const at = 4 * ((field[from] - row + y) * stride + field[from + 1] - column + x);
            red += rgba[at];
            green += rgba[at + 1];
            blue += rgba[at + 2];
          }
        const votes = (bottom - top + 1) * (right - left + 1);
        colours[to] = (2 * red + votes) / (2 * votes) | 0;
        colours[to + 1] = (2 * green + votes) / (2 * votes) | 0;
        colours[to + 2] = (2 * blue + votes) / (2 * votes) | 0;
        colours[to + 3] = 255;
      }
    }
  }

  // src/script/engine.ts
  var ScriptEngine = class {
    name = "script";
    canvas;
    stage;
    kept = [];
    shown;
    fields;
    voted;
    found = [];
    frames = [];
    constructor(canvas, stage) {
      const { width, height } = stage;
      this.canvas = canvas;
      this.stage = stage;
      this.shown = canvas.createImageData(width, height);
      this.fields = { shifted: new Uint16Array(2 * width * height), searched: new Uint16Array(2 * width * height) };
      this.voted = new Uint8Array(4 * width * height);
    }
    keep(slot, view) {
      this.kept[slot] = { ...view, labels: this.labelsOf(view) };
    }
    draw(moment) {
      this.shown.data.set(this.picture(moment));
      this.canvas.putImageData(this.shown, 0, 0);
    }
    finish() {
    }
    /** `places` are those of the views around, in every pixel one after the other. */
    read(buffer) {
      if (buffer === "shifted" || buffer === "searched") return this.fields[buffer];
      if (buffer === "places") {
        const views = this.found.length;
        return Int32Array.from({ length: views * this.found[0].length }, (_, i) => this.found[i % views][Math.floor(i / views)]);
      }
      if (buffer === "voted") return this.voted;
      return buffer === "mixed" ? Uint8Array.from(this.shown.data) : this.frames[Number(buffer.replace("frame", ""))];
    }
    /** Run the passes of a mode; returns four bytes a pixel. */
    picture(moment) {
      const { mode, around } = moment;
      const views = around.map((view) => this.kept[view.slot]);
      const mixed2 = new Uint8Array(this.voted.length);
      if (mode === "linear") {
        mix(views.map((view) => this.pictureOf(view)), around.map((view) => view.linear), mixed2);
        return mixed2;
      }
      const places = this.found = this.places(moment);
      if (mode === "image" || mode === "blend") {
        mixShifted(places, views.map((view) => this.pictureOf(view)), shiftedWeights(moment), mixed2);
        return mixed2;
      }
      const fields = views.map((view) => view.field);
      const frames = framesOf(moment);
      const made = [...frames].reverse().map(({ order }) => {
        const [ownPlaces, ownFields] = [order.map((k) => places[k]), order.map((k) => fields[k])];
        return this.frame(ownPlaces, ownFields, mode === "nnf");
      });
      this.frames = made.reverse();
      if (made.length === 1) return made[0];
      mix(this.frames, frames.map((frame) => frame.weight), mixed2);
      return mixed2;
    }
    frame(places, fields, isShiftAlone) {
      const { shifted, searched } = this.fields;
      shift(places, fields, shifted);
      vote(shifted, this.stage, this.voted);
      if (isShiftAlone) return this.voted;
      limitedSearch(places, fields, shifted, this.voted, this.stage, searched);
      const picture = new Uint8Array(this.voted.length);
      vote(searched, this.stage, picture);
      return picture;
    }
    places(moment) {
      const { lens, around, step } = moment;
      const { width, height } = this.stage;
      if (!lens) throw new Error("this mode needs the model");
      const [surface, near] = this.see(lens, moment);
      return around.map((view) => {
        const labels = this.kept[view.slot].labels;
        return placesIn(labels, lens, view.lens, surface, near, step, width, height);
      });
    }
    /** What a lens sees at every `step`-th pixel, and the pixel whose face and motion each takes. */
    see(lens, { around, step }) {
      const { width, height, mesh, reach } = this.stage;
      const views = around.map((view) => ({ points: this.kept[view.slot].points, lens: view.lens }));
      const surface = mesh ? raster(mesh, lens, width, height, step) : splat(views, lens, width, height, step);
      return [surface, beside2(surface, Math.max(1, Math.round(reach / step)))];
    }
    labelsOf({ lens, points }) {
      const { width, height, reach, mesh } = this.stage;
      if (!lens || !mesh && !points) return null;
      const surface = mesh ? raster(mesh, lens, width, height, 1) : surfaceOf(points, width, height);
      return Uint16Array.from(beside2(surface, reach), (q) => surface.faces[q]);
    }
    /** The picture of a view, which its field gives; made when a mode first needs it. */
    pictureOf(view) {
      if (!view.rgba) {
        view.rgba = new Uint8Array(this.voted.length);
        vote(view.field, this.stage, view.rgba);
      }
      return view.rgba;
    }
  };

  // src/webgl/context.ts
  var HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp isampler2D;
precision highp usampler2DArray;
`;
  var WHOLE2 = `
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4. - 1., 1., 1.);
}`;
  function program(fragment, vertex = WHOLE2) {
    return { fragment, vertex, linked: null };
  }
  var Context = class {
    gl;
    constructor(gl) {
      this.gl = gl;
      gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
      gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
      gl.disable(gl.DITHER);
    }
    texture(format, width, height, layers = 0) {
      const { gl } = this;
      const target = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
      const texture = gl.createTexture();
      gl.bindTexture(target, texture);
      if (layers) gl.texStorage3D(target, 1, gl[format], width, height, layers);
      else gl.texStorage2D(target, 1, gl[format], width, height);
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, filter, gl.NEAREST);
      return { texture, format, isArray: layers > 0 };
    }
    /** Set all pixels of a texture, or of a layer of it. */
    set(to, width, height, values, layer = 0) {
      const { gl } = this;
      const kind = KINDS[to.format];
      const [format, type] = [gl[kind.format], gl[kind.type]];
      if (to.isArray) {
        gl.bindTexture(gl.TEXTURE_2D_ARRAY, to.texture);
        gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, width, height, 1, format, type, values);
      } else {
        gl.bindTexture(gl.TEXTURE_2D, to.texture);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, values);
      }
    }
    target(textures, width, height, options = {}) {
      const { gl } = this;
      const framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      textures.forEach(({ texture, isArray }, i) => {
        if (isArray) gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, texture, 0, options.layer ?? 0);
        else gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0);
      });
      gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
      if (options.depth) gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, options.depth);
      return { framebuffer, width, height };
    }
    depth(width, height) {
      const { gl } = this;
      const depth = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
      return depth;
    }
    /** Take a program, its textures and its other uniforms, and a target; null is the canvas. */
    use(program2, values, target) {
      const { gl } = this;
      const { program: linked, uniforms } = program2.linked ??= this.link(program2);
      gl.bindFramebuffer(gl.FRAMEBUFFER, target ? target.framebuffer : null);
      if (target) gl.viewport(0, 0, target.width, target.height);
      else gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
      gl.useProgram(linked);
      let unit2 = 0;
      for (const [name, uniform] of uniforms) {
        const value = values[name];
        if (value === void 0) throw new Error(`the uniform ${name} is not set`);
        if (typeof value === "object" && "texture" in value) {
          gl.activeTexture(gl.TEXTURE0 + unit2);
          gl.bindTexture(value.isArray ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, value.texture);
          gl.uniform1i(uniform.location, unit2++);
        } else this.setNumbers(uniform, typeof value === "number" ? [value] : value);
      }
    }
    /** Draw the whole target with a program. */
    fill(program2, values, target) {
      this.use(program2, values, target);
      this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
    }
    /** Draw with the program in use what is nearest, by inverse depths; of what is as near the first. */
    drawNearest(mode, vertices) {
      const { gl } = this;
      gl.clearBufferfv(gl.DEPTH, 0, [0]);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.GREATER);
      gl.drawArrays(mode, 0, vertices);
      gl.disable(gl.DEPTH_TEST);
    }
    /** The pixels of a texture. */
    read(from, width, height) {
      const { gl } = this;
      const target = this.target([from], width, height);
      const isSigned = from.format === "RGBA16I";
      const all = isSigned ? new Int32Array(4 * width * height) : new Uint32Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, isSigned ? gl.INT : gl.UNSIGNED_INT, all);
      gl.deleteFramebuffer(target.framebuffer);
      const { channels, numbers } = KINDS[from.format];
      const read = new numbers(width * height * channels);
      for (let i = 0, to = 0; i < all.length; i += 4) for (let c = 0; c < channels; c++) read[to++] = all[i + c];
      return read;
    }
    link({ fragment, vertex }) {
      const { gl } = this;
      const program2 = gl.createProgram();
      const shaders = [["VERTEX_SHADER", vertex], ["FRAGMENT_SHADER", fragment]].map(([kind, source]) => {
        const shader = gl.createShader(gl[kind]);
        gl.shaderSource(shader, HEAD + source);
        gl.compileShader(shader);
        gl.attachShader(program2, shader);
        return shader;
      });
      gl.linkProgram(program2);
      if (!gl.getProgramParameter(program2, gl.LINK_STATUS) && !gl.isContextLost())
        throw new Error([gl.getProgramInfoLog(program2), ...shaders.map((each) => gl.getShaderInfoLog(each))].join(" "));
      const uniforms = /* @__PURE__ */ new Map();
      const count = gl.getProgramParameter(program2, gl.ACTIVE_UNIFORMS) ?? 0;
      for (let i = 0; i < count; i++) {
        const { name, type } = gl.getActiveUniform(program2, i);
        const location2 = gl.getUniformLocation(program2, name);
        uniforms.set(name.replace("[0]", ""), { location: location2, type });
      }
      return { program: program2, uniforms };
    }
    setNumbers({ location: location2, type }, numbers) {
      const { gl } = this;
      if (type === gl.INT) gl.uniform1iv(location2, numbers);
      else if (type === gl.INT_VEC2) gl.uniform2iv(location2, numbers);
      else if (type === gl.INT_VEC4) gl.uniform4iv(location2, numbers);
      else if (type === gl.FLOAT) gl.uniform1fv(location2, numbers);
      else if (type === gl.FLOAT_VEC2) gl.uniform2fv(location2, numbers);
      else if (type === gl.FLOAT_VEC3) gl.uniform3fv(location2, numbers);
      else if (type === gl.FLOAT_VEC4) gl.uniform4fv(location2, numbers);
      else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(location2, false, numbers);
      else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(location2, false, numbers);
      else throw new Error(`uniforms of type ${type} are not known here`);
    }
  };
  var KINDS = {
    R8UI: { channels: 1, numbers: Uint8Array, format: "RED_INTEGER", type: "UNSIGNED_BYTE" },
    R16UI: { channels: 1, numbers: Uint16Array, format: "RED_INTEGER", type: "UNSIGNED_SHORT" },
    RG16UI: { channels: 2, numbers: Uint16Array, format: "RG_INTEGER", type: "UNSIGNED_SHORT" },
    RG32UI: { channels: 2, numbers: Uint32Array, format: "RG_INTEGER", type: "UNSIGNED_INT" },
    RGBA8UI: { channels: 4, numbers: Uint8Array, format: "RGBA_INTEGER", type: "UNSIGNED_BYTE" },
    RGBA16I: { channels: 4, numbers: Int16Array, format: "RGBA_INTEGER", type: "SHORT" },
    RGBA32F: { channels: 4, numbers: Float32Array, format: "RGBA", type: "FLOAT" }
  };

  // src/webgl/silhouettes.ts
  var DEPTH = `
uniform usampler2D surface;
uniform ivec2 size;
float inverseAt(ivec2 p) { return uintBitsToFloat(texelFetch(surface, p, 0).y); }
bool isInside(ivec2 p) { return p == clamp(p, ivec2(0), size - 1); }
bool isNearer(float inverse, float other) { return inverse > 1.05 * other; }
`;
  var RIMS = `
${DEPTH}
layout(location = 0) out uint rim;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  float near = inverseAt(p);
  rim = 0u;
  for (int turn = 0; turn < 4; turn++) {
    ivec2 d = turn % 2 == 0 ? ivec2(0, turn - 1) : ivec2(turn - 2, 0);
    ivec2 q = p + d;
    if (!isInside(q)) continue;
    float far = inverseAt(q);
    // Outside of the picture the plane goes on.
    float before = isInside(p - d) ? inverseAt(p - d) : 2. * near - far;
    float behind = isInside(q + d) ? inverseAt(q + d) : 2. * far - near;
    float slope = min(abs(before - near), abs(far - behind));
    if (isNearer(near, far) && near - far > 2. * slope) rim = 1u;
  }
}`;
  var RIMS_IN_ROW = `
uniform usampler2D rims;
uniform ivec2 size;
uniform int reach;
layout(location = 0) out uint rim;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  rim = 0u;
  for (int x = max(p.x - reach, 0); x <= min(p.x + reach, size.x - 1); x++)
    rim |= texelFetch(rims, ivec2(x, p.y), 0).x;
}`;
  var BESIDE = `
${DEPTH}
uniform usampler2D rims, rimsInRow;
uniform int reach;
layout(location = 0) out uvec2 beside;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy), found = p;
  float own = inverseAt(p), nearest = 1e30;
  int closest = reach * reach + 1;
  for (int y = max(p.y - reach, 0); y <= min(p.y + reach, size.y - 1); y++) {
    if (texelFetch(rimsInRow, ivec2(p.x, y), 0).x == 0u) continue;
    for (int x = max(p.x - reach, 0); x <= min(p.x + reach, size.x - 1); x++) {
      ivec2 q = ivec2(x, y), d = q - p;
      int away = d.x * d.x + d.y * d.y;
      if (away > closest || texelFetch(rims, q, 0).x == 0u) continue;
      float there = inverseAt(q);
      if ((away < closest || there > nearest) && isNearer(there, own)) {
        closest = away;
        nearest = there;
        found = q;
      }
    }
  }
  if (closest <= reach * reach) {
    ivec2 past = found + sign(found - p);
    if (isInside(past) && !isNearer(nearest, inverseAt(past))) found = past;
  }
  beside = uvec2(found);
}`;
  var LABELS = `
uniform usampler2D surface, beside;
layout(location = 0) out uint label;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  label = texelFetch(surface, ivec2(texelFetch(beside, p, 0).xy), 0).x;
}`;

  // src/webgl/beside.ts
  var Beside = class {
    context;
    buffers;
    stage;
    targets;
    rims = program(RIMS);
    rimsInRow = program(RIMS_IN_ROW);
    beside = program(BESIDE);
    constructor(context, buffers, stage) {
      this.context = context;
      this.buffers = buffers;
      this.stage = stage;
      const target = (name) => context.target([buffers[name]], stage.width, stage.height);
      this.targets = { rims: target("rims"), rimsInRow: target("rimsInRow"), beside: target("beside") };
    }
    find(step) {
      const { surface, rims, rimsInRow } = this.buffers;
      const size = [this.stage.width, this.stage.height].map((side) => Math.ceil(side / step));
      const reach = Math.max(1, Math.round(this.stage.reach / step));
      const into = (target) => ({ ...target, width: size[0], height: size[1] });
      this.context.fill(this.rims, { surface, size }, into(this.targets.rims));
      this.context.fill(this.rimsInRow, { rims, size, reach }, into(this.targets.rimsInRow));
      this.context.fill(this.beside, { surface, rims, rimsInRow, size, reach }, into(this.targets.beside));
    }
  };

  // src/webgl/buffers.ts
  function makeBuffers(context, stage) {
    const { width, height, style, mesh, hasPoints: hasPoints2, slots } = stage;
    const kept = (format, isNeeded) => isNeeded ? context.texture(format, width, height, slots) : context.texture(format, 1, 1, 1);
    const work = (format) => context.texture(format, width, height);
    const field = () => context.texture("RG16UI", width, height, 1);
    const buffers = {
      fields: kept("RG16UI", style !== null),
      pictures: kept("RGBA8UI", true),
      points: kept("RG32UI", hasPoints2),
      labels: kept("R16UI", mesh !== null || hasPoints2),
      style: context.texture("RGBA8UI", style?.width ?? 1, style?.height ?? 1),
      sparse: work("RG32UI"),
      surface: work("RG32UI"),
      rims: work("R8UI"),
      rimsInRow: work("R8UI"),
      beside: work("RG16UI"),
      motion01: work("RGBA16I"),
      motion23: work("RGBA16I"),
      hidden: work("R8UI"),
      shifted: field(),
      voted: work("RGBA8UI"),
      searched: field(),
      frame0: work("RGBA8UI"),
      frame1: work("RGBA8UI"),
      frame2: work("RGBA8UI"),
      frame3: work("RGBA8UI"),
      mixed: work("RGBA8UI")
    };
    if (style) context.set(buffers.style, style.width, style.height, style.rgba);
    return buffers;
  }

  // src/webgl/finish.ts
  var MIX_FRAMES = `
uniform usampler2D frame0, frame1, frame2, frame3;
uniform ivec4 weights;
layout(location = 0) out uvec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uvec4 w = uvec4(weights);
  uint whole = w.x + w.y + w.z + w.w;
  uvec3 sum = w.x * texelFetch(frame0, p, 0).xyz + w.y * texelFetch(frame1, p, 0).xyz
            + w.z * texelFetch(frame2, p, 0).xyz + w.w * texelFetch(frame3, p, 0).xyz;
  colour = uvec4((2u * sum + whole) / (2u * whole), 255u);
}`;
  var SHOW = `
uniform usampler2D picture;
uniform ivec2 size;
layout(location = 0) out vec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  colour = vec4(vec3(texelFetch(picture, ivec2(p.x, size.y - 1 - p.y), 0).xyz) / 255., 1.);
}`;

  // src/webgl/candidates.ts
  var PLACES = `
uniform isampler2D motion01, motion23;
uniform usampler2D hidden;
uniform ivec2 size;
uniform ivec4 order, slots;
uniform int count, step, bits;
/** Whether view k shows the point of pixel p, and where; if it does not, where it would. */
bool shows(int k, ivec2 p, out ivec3 place) {
  ivec2 m = p / step;
  ivec4 two = k < 2 ? texelFetch(motion01, m, 0) : texelFetch(motion23, m, 0);
  ivec2 offset = (k & 1) == 0 ? two.xy : two.zw;
  ivec2 there = p + ((offset + ((1 << bits) >> 1)) >> bits);
  ivec2 q = clamp(there, ivec2(0), size - 1);
  place = ivec3(q, slots[k]);
  return q == there && (texelFetch(hidden, m, 0).x >> uint(k) & 1u) == 0u;
}
/** The place in the first view that shows the point of p; if none does, in the first of all. */
ivec3 chosen(ivec2 p) {
  ivec3 place;
  for (int n = 0; n < count; n++) if (shows(order[n], p, place)) return place;
  shows(order[0], p, place);
  return place;
}
`;

  // src/webgl/limited_search.ts
  var limitedSearch2 = (radius) => `
const int R = ${radius}, WIDTH = 2 * R + 1;
${PLACES}
uniform usampler2DArray fields, field;
uniform usampler2D style, picture;
layout(location = 0) out uvec2 patchAt;
ivec3 own[WIDTH * WIDTH];
int difference(ivec2 source) {
  int sum = 0;
  for (int y = -R; y <= R; y++) for (int x = -R; x <= R; x++) {
    ivec3 e = ivec3(texelFetch(style, source + ivec2(x, y), 0).xyz) - own[(y + R) * WIDTH + x + R];
    sum += e.x * e.x + e.y * e.y + e.z * e.z;
  }
  return sum;
}
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  for (int y = -R; y <= R; y++) for (int x = -R; x <= R; x++)
    own[(y + R) * WIDTH + x + R] = ivec3(texelFetch(picture, clamp(p + ivec2(x, y), ivec2(0), size - 1), 0).xyz);
  patchAt = texelFetch(field, ivec3(p, 0), 0).xy;
  int best = difference(ivec2(patchAt.yx));
  for (int n = 0; n < count; n++) {
    ivec3 place;
    if (!shows(order[n], p, place)) continue;
    uvec2 candidate = texelFetch(fields, place, 0).xy;
    if (candidate == patchAt) continue;
    int found = difference(ivec2(candidate.yx));
    if (found < best) { best = found; patchAt = candidate; }
  }
}`;

  // src/webgl/mesh_shader.ts
  var TEXELS = 4;
  var MESH_VERTEX = `
uniform highp sampler2D triangles;
uniform vec4 lens[3];
uniform vec3 eye;
uniform mat3 ray;
uniform vec2 middle;
uniform ivec2 size;
uniform int step;
flat out vec3 edges[3];
flat out vec3 inverseDepth;
flat out uint label;
vec4 texel(int n) { int width = textureSize(triangles, 0).x; return texelFetch(triangles, ivec2(n % width, n / width), 0); }
void main() {
  int first = gl_VertexID / 3 * ${TEXELS};
  vec3 corners[3];
  for (int k = 0; k < 3; k++) {
    vec4 point = vec4(texel(first + k).xyz, 1.);
    float z = dot(lens[2], point);
    corners[k] = vec3(dot(lens[0], point) - middle.x * z, dot(lens[1], point) - middle.y * z, z);
  }
  for (int k = 0; k < 3; k++) edges[k] = cross(corners[(k + 1) % 3], corners[(k + 2) % 3] - corners[(k + 1) % 3]);
  float turn = dot(corners[0], edges[0]) < 0. ? -1. : 1.;
  for (int k = 0; k < 3; k++) edges[k] *= turn;
  vec4 plane = texel(first + 3);
  inverseDepth = plane.xyz * ray / -(dot(plane.xyz, eye) + plane.w);
  label = uint(texel(first).w);
  vec3 larger[2];
  for (int k = 0; k < 2; k++) {
    vec3 edge = edges[(gl_VertexID + k + 1) % 3];
    larger[k] = edge + vec3(0., 0., float(step) * (abs(edge.x) + abs(edge.y)));
  }
  vec3 corner = turn * cross(larger[0], larger[1]);
  corner.xy += middle * corner.z;
  vec2 clip = (2. * corner.xy + corner.z) / float(step) / vec2(size) - corner.z;
  gl_Position = vec4(clip, 0., corner.z);
}`;
  var SURFACE = `
flat in vec3 edges[3];
flat in vec3 inverseDepth;
flat in uint label;
uniform vec2 middle;
uniform float near;
uniform int step;
layout(location = 0) out uvec2 surface;  // face, bits of the inverse depth
void main() {
  vec2 at = gl_FragCoord.xy * float(step) - .5;
  vec3 centred = vec3(at - middle, 1.);
  for (int k = 0; k < 3; k++) if (!(dot(edges[k], centred) >= 0.)) discard;
  float inverse = dot(inverseDepth, vec3(at, 1.));
  if (!(inverse > 0. && inverse * near < 1.)) discard;
  surface = uvec2(label, floatBitsToUint(inverse));
  gl_FragDepth = inverse * near;
}`;

  // src/webgl/mesh_surface.ts
  var MeshSurface = class {
    context;
    stage;
    count;
    triangles;
    target;
    surface = program(SURFACE, MESH_VERTEX);
    constructor(context, buffers, stage, mesh) {
      this.context = context;
      this.stage = stage;
      this.count = mesh.faces.length;
      this.triangles = uploaded(context, mesh);
      const { width, height } = stage;
      this.target = context.target([buffers.surface], width, height, { depth: context.depth(width, height) });
    }
    seeView(_slot, lens) {
      this.see(lens, 1);
    }
    seePlace(moment) {
      this.see(moment.lens, moment.step);
    }
    see(lens, step) {
      const { context } = this;
      const { gl } = context;
      const [width, height] = [this.stage.width, this.stage.height].map((side) => Math.ceil(side / step));
      const { eye, near, right, below, corner } = lens;
      const values = {
        triangles: this.triangles,
        lens: [lens.across, lens.down, lens.depth].flat(),
        eye,
        near,
        step,
        size: [width, height],
        ray: [...right, ...below, ...corner],
        middle: [this.stage.width / 2, this.stage.height / 2]
      };
      context.use(this.surface, values, { ...this.target, width, height });
      gl.clearBufferuiv(gl.COLOR, 0, [SKY, 0, 0, 0]);
      context.drawNearest(gl.TRIANGLES, 3 * this.count);
    }
  };
  function uploaded(context, mesh) {
    const count = mesh.faces.length;
    const width = TEXELS * Math.min(count, 512);
    const height = Math.ceil(TEXELS * count / width);
    const texels = new Float32Array(4 * width * height);
    for (let t = 0; t < count; t++) {
      const to = 4 * TEXELS * t;
      for (let k = 0; k < 3; k++) {
        texels.set(mesh.corners.subarray(9 * t + 3 * k, 9 * t + 3 * k + 3), to + 4 * k);
        texels[to + 4 * k + 3] = mesh.faces[t];
      }
      texels.set(mesh.planes.subarray(4 * t, 4 * t + 4), to + 12);
    }
    const texture = context.texture("RGBA32F", width, height);
    context.set(texture, width, height, texels);
    return texture;
  }

  // src/webgl/motion.ts
  var MOTION = `
uniform usampler2D surface, beside;
uniform usampler2DArray labels;
uniform vec4 transfers[12];
uniform ivec4 slots;
uniform ivec2 size;
uniform int count, step, bits;
layout(location = 0) out ivec4 motion01;
layout(location = 1) out ivec4 motion23;
layout(location = 2) out uint hidden;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy), near = ivec2(texelFetch(beside, p, 0).xy);
  uvec2 seen = texelFetch(surface, near, 0).xy;
  float v = uintBitsToFloat(seen.y);
  // Of what lies beside it a pixel takes the motion, not the place.
  vec2 at = (vec2(near) + .5) * float(step) - .5, own = (vec2(p) + .5) * float(step) - .5;
  ivec2 offsets[4];
  hidden = 0u;
  for (int k = 0; k < 4; k++) {
    offsets[k] = ivec2(0);
    if (k >= count) continue;
    vec2 motion = vec2(0.);
    if (v > 0.) {
      vec4 pixel = vec4(at, 1., v);
      float depth = dot(transfers[3 * k + 2], pixel);
      motion = vec2(dot(transfers[3 * k], pixel), dot(transfers[3 * k + 1], pixel)) / depth - at;
      if (!(depth > 0.) || any(greaterThan(abs(motion), vec2(size)))) { hidden |= 1u << k; continue; }
    }
    ivec2 q = ivec2(floor(own + motion + .5));
    bool shown = q == clamp(q, ivec2(0), size - 1) && texelFetch(labels, ivec3(q, slots[k]), 0).x == seen.x;
    if (!shown) hidden |= 1u << k;
    offsets[k] = ivec2(clamp(floor(motion * float(1 << bits) + .5), -32767., 32767.));
  }
  motion01 = ivec4(offsets[0], offsets[1]);
  motion23 = ivec4(offsets[2], offsets[3]);
}`;

  // src/webgl/point_surface.ts
  var SPLAT_VERTEX = `
uniform usampler2DArray points;
uniform vec4 transfers[12];
uniform ivec4 slots;
uniform ivec2 viewSize, size;
uniform int step;
flat out uint label;
flat out float inverse;
flat out float merit;
void main() {
  int pixels = viewSize.x * viewSize.y, k = gl_VertexID / pixels, n = gl_VertexID % pixels;
  ivec2 from = ivec2(n % viewSize.x, n / viewSize.x);
  uvec2 seen = texelFetch(points, ivec3(from, slots[k]), 0).xy;
  float v = uintBitsToFloat(seen.y);
  vec4 pixel = vec4(from, 1., v);
  float depth = dot(transfers[3 * k + 2], pixel);
  vec2 at = vec2(dot(transfers[3 * k], pixel), dot(transfers[3 * k + 1], pixel)) / depth;
  label = seen.x;
  inverse = v / depth;
  gl_PointSize = 1.;
  vec2 landed = floor((floor(at + .5) + .5) / float(step)) + .5;
  vec2 away = (at + .5) / float(step) - landed;
  merit = inverse * (1. - ${SLACK} * dot(away, away));
  gl_Position = v > 0. && depth > 0. ? vec4(2. * landed / vec2(size) - 1., 0., 1.) : vec4(2., 2., 0., 1.);
}`;
  var SPLAT = `
flat in uint label;
flat in float inverse;
flat in float merit;
uniform float near;
layout(location = 0) out uvec2 surface;
void main() {
  surface = uvec2(label, floatBitsToUint(inverse));
  gl_FragDepth = merit * near;
}`;
  var FILL_HOLES = `
uniform usampler2D sparse;
uniform ivec2 size;
layout(location = 0) out uvec2 surface;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  surface = texelFetch(sparse, p, 0).xy;
  if (surface.x != ${SKY}u) return;
  for (int k = 0; k < 2; k++) {
    ivec2 d = ivec2(1 - k, k);
    if (p - d != clamp(p - d, ivec2(0), size - 1) || p + d != clamp(p + d, ivec2(0), size - 1)) continue;
    uvec2 one = texelFetch(sparse, p - d, 0).xy, other = texelFetch(sparse, p + d, 0).xy;
    if (one.x == ${SKY}u || other.x == ${SKY}u) continue;
    surface = uintBitsToFloat(other.y) < uintBitsToFloat(one.y) ? other : one;
    return;
  }
}`;
  var COPY = `
uniform usampler2DArray points;
uniform int slot;
layout(location = 0) out uvec2 surface;
void main() { surface = texelFetch(points, ivec3(gl_FragCoord.xy, slot), 0).xy; }`;
  var PointSurface = class {
    context;
    buffers;
    stage;
    sparse;
    surface;
    splat = program(SPLAT, SPLAT_VERTEX);
    fillHoles = program(FILL_HOLES);
    copy = program(COPY);
    constructor(context, buffers, stage) {
      const { width, height } = stage;
      this.context = context;
      this.buffers = buffers;
      this.stage = stage;
      this.sparse = context.target([buffers.sparse], width, height, { depth: context.depth(width, height) });
      this.surface = context.target([buffers.surface], width, height);
    }
    seeView(slot) {
      this.context.fill(this.copy, { points: this.buffers.points, slot }, this.surface);
    }
    seePlace({ lens, around, step }) {
      const { context, stage } = this;
      const { gl } = context;
      const [width, height] = [stage.width, stage.height].map((side) => Math.ceil(side / step));
      const place = lens;
      const rows = around.flatMap((view) => transferOf(view.lens, place)).flat();
      const { points, sparse } = this.buffers;
      const size = [width, height];
      const values = {
        points,
        size,
        step,
        transfers: [...rows, ...Array(48 - rows.length).fill(0)],
        slots: [0, 1, 2, 3].map((k) => around[k]?.slot ?? 0),
        viewSize: [stage.width, stage.height],
        near: place.near
      };
      context.use(this.splat, values, { ...this.sparse, width, height });
      gl.clearBufferuiv(gl.COLOR, 0, [SKY, 0, 0, 0]);
      context.drawNearest(gl.POINTS, around.length * stage.width * stage.height);
      context.fill(this.fillHoles, { sparse, size }, { ...this.surface, width, height });
    }
  };

  // src/webgl/shift.ts
  var SHIFT = `
${PLACES}
uniform usampler2DArray fields;
layout(location = 0) out uvec2 patchAt;
void main() { patchAt = texelFetch(fields, chosen(ivec2(gl_FragCoord.xy)), 0).xy; }`;
  var MIX_SHIFTED = `
${PLACES}
uniform usampler2DArray pictures;
uniform ivec4 weights;
layout(location = 0) out uvec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uvec3 sum = uvec3(0u);
  uint whole = 0u;
  for (int k = 0; k < count; k++) {
    ivec3 place;
    uint weight = uint(weights[k]);
    if (weight == 0u || !shows(k, p, place)) continue;
    sum += weight * texelFetch(pictures, place, 0).xyz;
    whole += weight;
  }
  colour = whole == 0u ? texelFetch(pictures, chosen(p), 0) : uvec4((2u * sum + whole) / (2u * whole), 255u);
}`;
  var MIX_VIEWS = `
uniform usampler2DArray pictures;
uniform ivec4 slots, weights;
uniform int count;
layout(location = 0) out uvec4 colour;
void main() {
  uvec3 sum = uvec3(0u);
  uint whole = 0u;
  for (int k = 0; k < count; k++) {
    sum += uint(weights[k]) * texelFetch(pictures, ivec3(gl_FragCoord.xy, slots[k]), 0).xyz;
    whole += uint(weights[k]);
  }
  colour = uvec4((2u * sum + whole) / (2u * whole), 255u);
}`;

  // src/webgl/vote.ts
  var vote2 = (radius) => `
const int R = ${radius};
uniform usampler2DArray field;
uniform usampler2D style;
uniform int layer;
uniform ivec2 size;
layout(location = 0) out uvec4 colour;
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  uvec3 sum = uvec3(0u);
  uint votes = 0u;
  for (int y = -R; y <= R; y++) for (int x = -R; x <= R; x++) {
    ivec2 q = p + ivec2(x, y);
    if (q != clamp(q, ivec2(0), size - 1)) continue;
    ivec2 source = ivec2(texelFetch(field, ivec3(q, layer), 0).yx) - ivec2(x, y);
    sum += texelFetch(style, source, 0).xyz;
    votes++;
  }
  colour = uvec4((2u * sum + votes) / (2u * votes), 255u);
}`;

  // src/webgl/engine.ts
  var FINE_BITS = 4;
  var FRAMES = ["frame0", "frame1", "frame2", "frame3"];
  var WebglEngine = class {
    name = "webgl";
    context;
    stage;
    buffers;
    surface;
    beside;
    targets = /* @__PURE__ */ new Map();
    hasPicture;
    labels = program(LABELS);
    motion = program(MOTION);
    shift = program(SHIFT);
    vote;
    search;
    mixFrames = program(MIX_FRAMES);
    mixShifted = program(MIX_SHIFTED);
    mixViews = program(MIX_VIEWS);
    show = program(SHOW);
    constructor(gl, stage) {
      this.context = new Context(gl);
      this.stage = stage;
      this.hasPicture = Array(stage.slots).fill(false);
      this.buffers = makeBuffers(this.context, stage);
      if (stage.mesh) this.surface = new MeshSurface(this.context, this.buffers, stage, stage.mesh);
      else this.surface = stage.hasPoints ? new PointSurface(this.context, this.buffers, stage) : null;
      this.beside = new Beside(this.context, this.buffers, stage);
      this.vote = program(vote2(stage.patchRadius));
      this.search = program(limitedSearch2(stage.patchRadius));
    }
    keep(slot, view) {
      const { context, buffers } = this;
      const { width, height } = this.stage;
      if (view.field) context.set(buffers.fields, width, height, view.field, slot);
      if (view.rgba) context.set(buffers.pictures, width, height, view.rgba, slot);
      this.hasPicture[slot] = view.rgba !== null;
      if (view.points) context.set(buffers.points, width, height, view.points, slot);
      if (!view.lens || !this.surface) return;
      this.surface.seeView(slot, view.lens);
      this.beside.find(1);
      const { surface, beside: beside3 } = buffers;
      context.fill(this.labels, { surface, beside: beside3 }, this.layer("labels", slot));
    }
    draw(moment) {
      const picture = this.picture(moment);
      this.context.fill(this.show, { picture, size: this.size }, null);
    }
    /** Only what is read is surely there. */
    finish() {
      const { gl } = this.context;
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    }
    read(buffer) {
      const { width, height } = this.stage;
      return this.context.read(this.buffers[buffer], width, height);
    }
    get size() {
      return [this.stage.width, this.stage.height];
    }
    /** Run the passes of a mode; returns the texture that they end in. */
    picture(moment) {
      const { mode, around } = moment;
      const { pictures, voted, mixed: mixed2 } = this.buffers;
      const slots = around.map((view) => view.slot);
      const views = { slots: four(slots), count: slots.length };
      if (mode === "linear") {
        this.votePictures(slots);
        const weights2 = four(around.map((view) => view.linear));
        this.fill(this.mixViews, { ...views, weights: weights2, pictures }, "mixed");
        return mixed2;
      }
      const places = { ...views, ...this.findMotion(moment) };
      if (mode === "image" || mode === "blend") {
        this.votePictures(slots);
        const values = { ...places, weights: four(shiftedWeights(moment)), order: four([0, 1, 2, 3]), pictures };
        this.fill(this.mixShifted, values, "mixed");
        return mixed2;
      }
      const frames = framesOf(moment);
      for (const n of [...frames.keys()].reverse()) this.makeFrame(mode === "nnf", frames[n].order, places, FRAMES[n]);
      if (mode === "nnf") return voted;
      if (frames.length === 1) return this.buffers.frame0;
      const { frame0, frame1, frame2, frame3 } = this.buffers;
      const weights = four(frames.map((frame) => frame.weight));
      this.fill(this.mixFrames, { frame0, frame1, frame2, frame3, weights }, "mixed");
      return mixed2;
    }
    /** Shift and vote; search and vote. */
    makeFrame(isShiftAlone, order, places, into) {
      const { fields, shifted, voted, searched, style } = this.buffers;
      const asked = { ...places, order: four(order), fields };
      this.fill(this.shift, asked, "shifted");
      this.fill(this.vote, { field: shifted, layer: 0, style, size: this.size }, "voted");
      if (isShiftAlone) return;
      this.fill(this.search, { ...asked, field: shifted, picture: voted, style }, "searched");
      this.fill(this.vote, { field: searched, layer: 0, style, size: this.size }, into);
    }
    /** Find the motion of a moment; returns what passes need to read it. */
    findMotion(moment) {
      const { lens, around, step } = moment;
      const { surface, beside: beside3, labels, motion01, motion23, hidden } = this.buffers;
      if (!lens || !this.surface) throw new Error("this mode needs the model");
      this.see(this.surface, moment);
      const [width, height] = this.size.map((side) => Math.ceil(side / step));
      const rows = around.flatMap((view) => transferOf(lens, view.lens)).flat();
      const transfers = [...rows, ...Array(48 - rows.length).fill(0)];
      const values = {
        surface,
        beside: beside3,
        labels,
        transfers,
        slots: four(around.map((view) => view.slot)),
        size: this.size,
        count: around.length,
        step,
        bits: step === 1 ? 0 : FINE_BITS
      };
      const target = this.made(
        `motion ${step}`,
        () => this.context.target([motion01, motion23, hidden], width, height)
      );
      this.context.fill(this.motion, values, target);
      const { size, bits } = values;
      return { motion01, motion23, hidden, size, step, bits };
    }
    /** What a lens sees at every `step`-th pixel, and the pixel whose face and motion each takes. */
    see(surface, moment) {
      surface.seePlace(moment);
      this.beside.find(moment.step);
    }
    /** The pictures of views, which their fields give; made when a mode first needs them. */
    votePictures(slots) {
      const { fields, style } = this.buffers;
      for (const layer of slots.filter((slot) => !this.hasPicture[slot])) {
        this.context.fill(this.vote, { field: fields, layer, style, size: this.size }, this.layer("pictures", layer));
        this.hasPicture[layer] = true;
      }
    }
    fill(of, values, into) {
      const { width, height } = this.stage;
      const target = this.made(into, () => this.context.target([this.buffers[into]], width, height));
      this.context.fill(of, values, target);
    }
    layer(of, layer) {
      const { width, height } = this.stage;
      return this.made(`${of} ${layer}`, () => this.context.target([this.buffers[of]], width, height, { layer }));
    }
    made(name, make) {
      let target = this.targets.get(name);
      if (!target) this.targets.set(name, target = make());
      return target;
    }
  };
  function four(numbers) {
    return [0, 1, 2, 3].map((k) => numbers[k] ?? 0);
  }

  // src/engines.ts
  var SETTINGS = {
    alpha: false,
    antialias: false,
    depth: false,
    powerPreference: "high-performance"
  };
  var EMULATED = /swiftshader|llvmpipe|softpipe|basic render/i;
  var Engines = class {
    canvas;
    gl;
    flat;
    /** `longest` is the longest side of all images, which textures have to hold. */
    constructor(canvas, width, height, longest, asked) {
      canvas.width = width;
      canvas.height = height;
      this.canvas = canvas;
      const chosen2 = asked ?? (hasProcessor(longest) ? "webgl" : "script");
      this.gl = chosen2 === "webgl" ? canvas.getContext("webgl2", SETTINGS) : null;
      this.flat = this.gl ? null : canvas.getContext("2d");
      if (!this.gl && !this.flat)
        throw new PageError("This browser can draw neither with WebGL 2 nor on a canvas. Open the page in another one.");
    }
    make(stage) {
      return this.gl ? new WebglEngine(this.gl, stage) : new ScriptEngine(this.flat, stage);
    }
    /** A browser may take a WebGL context away, and give it back without what was in it. */
    onRestored(lost, restored) {
      this.canvas.addEventListener("webglcontextlost", (event) => {
        event.preventDefault();
        lost();
      });
      this.canvas.addEventListener("webglcontextrestored", restored);
    }
  };
  function hasProcessor(longest) {
    const gl = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
    if (!gl || gl.getParameter(gl.MAX_TEXTURE_SIZE) < longest) return false;
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return !EMULATED.test(name);
  }

  // src/mesh.ts
  function meshOf(data, bytes) {
    const count = data.triangles;
    const corners = new Float32Array(bytes.buffer, 0, 9 * count);
    const labels = new Uint32Array(bytes.buffer, 36 * count, count);
    const planes = new Float32Array(4 * count);
    for (let t = 0; t < count; t++) {
      const [a, b, c] = [0, 3, 6].map((from) => corners.subarray(9 * t + from, 9 * t + from + 3));
      const normal = unit(cross(minus(b, a), minus(c, a)));
      planes.set([...normal, -dot(normal, a)], 4 * t);
    }
    return { corners, faces: Uint16Array.from(labels, (label) => label % SKY), planes };
  }

  // src/modes.ts
  var MODES = {
    linear: "Linear blending of the views",
    image: "Image shifting",
    blend: "Blend of the shifted images",
    nnf: "NNF shifting",
    limited: "NNF shifting, limited search",
    fade: "Limited search, cross-fade"
  };
  var needsFields = (mode) => mode === "nnf" || mode === "limited" || mode === "fade";
  var needsModel = (mode) => mode !== "linear";
  var STEPS = { full: 1, half: 2, quarter: 4 };

  // src/panel.ts
  var byId = (id) => document.getElementById(id);
  var Panel = class {
    canvas = byId("drawing");
    message = byId("message");
    mode = byId("mode");
    motion = byId("motion");
    save = byId("save");
    view = byId("view");
    rate = byId("rate");
    waiting = byId("waiting");
    remark = "";
    /** A sentence in place of the drawing; an empty one shows it again. */
    say(sentence2) {
      this.message.textContent = sentence2;
      this.message.hidden = !sentence2;
      byId("viewer").hidden = !!sentence2;
    }
    /** Offer the modes that the page has data for. */
    offer(hasFields, hasModel, mode, motion, chosen2) {
      for (const [name, text] of Object.entries(MODES)) {
        if (needsFields(name) && !hasFields || needsModel(name) && !hasModel) continue;
        this.mode.add(new Option(text, name, false, name === mode));
      }
      for (const name of Object.keys(STEPS)) this.motion.add(new Option(`${name} resolution`, name, false, name === motion));
      this.motion.disabled = !hasModel;
      this.mode.onchange = () => chosen2.mode(this.mode.value);
      this.motion.onchange = () => chosen2.motion(this.motion.value);
      this.save.onclick = () => chosen2.save();
    }
    /** Where one is; screen readers hear it, so it is told when the drawing rests. */
    tellView(text) {
      this.view.textContent = text;
      this.canvas.setAttribute("aria-label", `${document.title}, seen ${text}. Arrow keys turn it.`);
    }
    tellRate(framesPerSecond) {
      const number = framesPerSecond === null ? "" : framesPerSecond.toFixed(framesPerSecond < 9.95 ? 1 : 0);
      this.rate.textContent = number && `${number} frames a second`;
    }
    tellWaiting(text) {
      this.waiting.textContent = text || this.remark;
    }
    /** What is told as long as there is nothing else. */
    tellRemark(text) {
      this.remark = text;
      this.tellWaiting("");
    }
    /** Give the still to the user as a file. */
    download(blob, name) {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 6e4);
    }
  };

  // src/parameters.ts
  var ENGINES = ["webgl", "script"];
  function readParameters(search) {
    const given = new URLSearchParams(search);
    const strange = [];
    const oneOf = (key, names) => {
      const value = given.get(key);
      const found = names.find((name) => name === value) ?? null;
      if (value !== null && found === null)
        strange.push(`The address asks for ${key}=${value}; choose one of ${names.join(", ")}.`);
      return found;
    };
    const place = () => {
      const text = given.get("view");
      if (text === null) return null;
      const numbers = text.split(",").map((word) => word.trim() ? Number(word) : NaN);
      if (numbers.length === 2 && numbers.every(Number.isFinite)) return numbers;
      strange.push(`The address asks for view=${text}; a place is two numbers, such as 2.5,-1.25.`);
      return null;
    };
    return {
      view: place(),
      mode: oneOf("mode", Object.keys(MODES)),
      motion: oneOf("motion", Object.keys(STEPS)) ?? "full",
      engine: oneOf("engine", ENGINES),
      strange
    };
  }

  // src/pixels.ts
  function toRgba(colours) {
    const rgba = new Uint8Array(colours.length / 3 * 4).fill(255);
    for (let from = 0, to = 0; from < colours.length; from += 3, to += 4) {
      rgba[to] = colours[from];
      rgba[to + 1] = colours[from + 1];
      rgba[to + 2] = colours[from + 2];
    }
    return rgba;
  }

  // src/embedding.ts
  var DECODER = new TextDecoder("windows-1252");
  var ESCAPE = 61;
  var BYTES = new Uint8Array(65536);
  var LETTERS = DECODER.decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
  for (let byte = 0; byte < 256; byte++) BYTES[LETTERS.charCodeAt(byte)] = byte;
  function bytesIn(text) {
    const bytes = new Uint8Array(text.length);
    let length = 0;
    for (let i = 0; i < text.length; i++) {
      const byte = BYTES[text.charCodeAt(i)];
      bytes[length++] = byte === ESCAPE ? BYTES[text.charCodeAt(++i)] - 64 : byte;
    }
    return bytes.slice(0, length);
  }
  var PROBE = "stylit-probe";
  async function pageAsWritten() {
    if (isAsWritten(document)) return document;
    const page = await loadedAgain();
    if (page && isAsWritten(page)) return page;
    throw new PageError("This page is damaged: a program saved it again in another text encoding. Ask for it again.");
  }
  async function loadedAgain() {
    if (!location.protocol.startsWith("http")) return null;
    try {
      const page = await fetch(location.href);
      return new DOMParser().parseFromString(DECODER.decode(await page.arrayBuffer()), "text/html");
    } catch {
      return null;
    }
  }
  function isAsWritten(page) {
    const probe = page.getElementById(PROBE);
    return !probe || probe.textContent === LETTERS[255];
  }

  // src/source.ts
  function sourceOf(data) {
    return data.folder === null ? inPage() : inFolder(data.folder);
  }
  function inPage() {
    const page = pageAsWritten();
    return async (name) => {
      const text = (await page).getElementById(name)?.textContent;
      if (text == null) throw new PageError(`This page is incomplete: ${name} is missing. Ask for it again.`);
      return bytesIn(text);
    };
  }
  function inFolder(folder) {
    const arrived = /* @__PURE__ */ new Map();
    window.stylitPiece = (name, text) => arrived.set(name, text);
    return (name) => new Promise((resolve, reject) => {
      const script = document.createElement("script");
      const file = `${folder}/${name}.js`;
      script.src = file;
      script.onload = () => {
        const text = arrived.get(name);
        arrived.delete(name);
        script.remove();
        const bytes = text === void 0 ? null : fromBase64(text);
        if (bytes) resolve(bytes);
        else reject(new PageError(`${file} is damaged. Copy the whole folder again.`));
      };
      script.onerror = () => {
        script.remove();
        reject(new PageError(`${file} is missing. Copy the whole folder again.`));
      };
      document.head.append(script);
    });
  }
  function fromBase64(text) {
    try {
      return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    } catch {
      return null;
    }
  }

  // src/still.ts
  function mixed(pictures, weights) {
    if (pictures.length === 1) return pictures[0];
    const [{ width, height }] = pictures;
    const image = new ImageData(width, height);
    const whole = weights.reduce((sum, weight) => sum + weight, 0);
    for (let i = 0; i < image.data.length; i++) {
      let sum = 0;
      for (const [k, picture] of pictures.entries()) sum += weights[k] * picture.data[i];
      image.data[i] = Math.floor((2 * sum + whole) / (2 * whole));
    }
    return image;
  }
  function replay(field, width, height, radius, { scale, width: stride, rgba }) {
    const image = new ImageData(width * scale, height * scale);
    const colours = image.data;
    for (let fineY = 0, to = 0; fineY < height * scale; fineY++) {
      const y = Math.floor(fineY / scale);
      const [top, bottom] = [Math.max(y - radius, 0), Math.min(y + radius, height - 1)];
      for (let fineX = 0; fineX < width * scale; fineX++, to += 4) {
        const x = Math.floor(fineX / scale);
        const [left, right] = [Math.max(x - radius, 0), Math.min(x + radius, width - 1)];
        const sum = [0, 0, 0];
        for (let row = top; row <= bottom; row++)
          for (let column = left; column <= right; column++) {
            const from = 2 * (row * width + column);
            const sourceY = (field[from] - row + y) * scale + fineY % scale;
            const sourceX = (field[from + 1] - column + x) * scale + fineX % scale;
            const at = 4 * (sourceY * stride + sourceX);
            for (let c = 0; c < 3; c++) sum[c] += rgba[at + c];
          }
        const votes = (bottom - top + 1) * (right - left + 1);
        for (let c = 0; c < 3; c++) colours[to + c] = Math.floor((2 * sum[c] + votes) / (2 * votes));
        colours[to + 3] = 255;
      }
    }
    return image;
  }

  // src/fields.ts
  var BEFORE = [
    [0, -1],
    [-1, 0],
    [-1, 1],
    [-1, -1],
    [0, -2],
    [-2, 0],
    [-2, 1],
    [-1, 2],
    [-2, -1],
    [-1, -2],
    [-2, 2],
    [-2, -2]
  ];
  var NEW = BEFORE.length;
  function fieldOf(bytes, width, height) {
    const origins = bytes.subarray(0, width * height);
    const count = origins.reduce((sum, origin) => sum + Number(origin === NEW), 0);
    const plane = (k) => bytes.subarray(origins.length + k * count, origins.length + (k + 1) * count);
    const [low, middleY, middleX, high] = [plane(0), plane(1), plane(2), plane(3)];
    const field = new Uint16Array(2 * origins.length);
    let [y, x] = [0, 0];
    for (let p = 0, n = 0; p < origins.length; p++) {
      if (origins[p] === NEW) {
        const top = high.length ? high[n] : 0;
        y += unfolded(low[n] & 15 | middleY[n] << 4 | (top & 15) << 12);
        x += unfolded(low[n] >> 4 | middleX[n] << 4 | top >> 4 << 12);
        n++;
      } else {
        const [down, right] = BEFORE[origins[p]];
        const from = 2 * (p + down * width + right);
        y = field[from] - down;
        x = field[from + 1] - right;
      }
      field[2 * p] = y;
      field[2 * p + 1] = x;
    }
    return field;
  }
  var unfolded = (number) => number & 1 ? -(number + 1) / 2 : number / 2;

  // src/store.ts
  var Store = class {
    data;
    source;
    pixels = /* @__PURE__ */ new Map();
    /** By view; the one that was needed last stands last. */
    slots = /* @__PURE__ */ new Map();
    coming = /* @__PURE__ */ new Map();
    wanted = [];
    engine = null;
    constructor(data, source) {
      this.data = data;
      this.source = source;
    }
    /** Hand all views to an engine, now and as they come. */
    attach(engine) {
      this.engine = engine;
      for (const [view, slot] of this.slots) engine.keep(slot, this.pixels.get(view));
    }
    /** Where views are kept; null if some are still to come, which are asked for. */
    need(views) {
      this.want(views);
      return views.every((view) => this.slots.has(view)) ? views.map((view) => this.slots.get(view)) : null;
    }
    /** When views are there, or a sentence says why not. */
    async arrived(views) {
      this.want(views);
      await Promise.all(views.filter((view) => !this.slots.has(view)).map((view) => this.fetch(view)));
    }
    /** Ask for views that may be needed next, one after the other, until others are needed. */
    async prepare(views) {
      const { wanted } = this;
      for (const view of views) {
        if (this.wanted !== wanted) return;
        if (this.slots.has(view)) continue;
        await this.fetch(view);
        await new Promise((resolve) => setTimeout(resolve));
      }
    }
    /** None of these gives way; and of the others those before them do. */
    want(views) {
      this.wanted = views;
      for (const view of views) {
        const slot = this.slots.get(view);
        if (slot === void 0) continue;
        this.slots.delete(view);
        this.slots.set(view, slot);
      }
    }
    fetch(view) {
      let coming = this.coming.get(view);
      if (!coming) {
        coming = this.decoded(view).then((pixels) => this.keep(view, pixels)).finally(() => this.coming.delete(view));
        this.coming.set(view, coming);
      }
      return coming;
    }
    async decoded(view) {
      const { nnf, picture, points, camera } = this.data.views[view];
      const { width, height } = this.data;
      const bytes = (piece) => piece && decode(piece, this.source);
      const [field, colours, planes] = await Promise.all([bytes(nnf), bytes(picture), bytes(points)]);
      return {
        field: field && fieldOf(field, width, height),
        rgba: colours && toRgba(colours),
        points: planes && pointsOf(planes, width, height),
        lens: camera && lensOf(camera, width, height)
      };
    }
    keep(view, pixels) {
      const slot = this.freeSlot();
      this.pixels.set(view, pixels);
      this.slots.set(view, slot);
      this.engine?.keep(slot, pixels);
    }
    freeSlot() {
      if (this.slots.size < SLOTS) return this.slots.size;
      const oldest = [...this.slots.keys()].find((view) => !this.wanted.includes(view));
      const slot = this.slots.get(oldest);
      this.slots.delete(oldest);
      this.pixels.delete(oldest);
      return slot;
    }
  };

  // src/pace.ts
  var SLOW = 50;
  var REMEMBERED = 8;
  var ENOUGH = 3;
  var PROMPT = 20;
  var Pace = class {
    intervals = [];
    last = null;
    /** When the last frame was handed to the browser. */
    drawn = 0;
    /** Milliseconds of a frame with all passes; 0 as long as none was drawn. */
    whole = 0;
    /** A frame was drawn in motion, with all passes or without: when it was asked for, begun and drawn. */
    moved(asked, begun, drawn, isWhole) {
      const isPrompt = this.last !== null && asked - this.drawn < PROMPT;
      this.intervals = isPrompt ? [...this.intervals, begun - this.last].slice(-REMEMBERED) : [];
      [this.last, this.drawn] = [begun, drawn];
      if (isWhole && this.intervals.length >= ENOUGH) this.whole = this.interval;
    }
    /** The motion has ended; a frame with all passes may have been drawn since. */
    rested(wholeFrame) {
      this.last = null;
      if (wholeFrame !== null) this.whole = wholeFrame;
    }
    /** Whether a frame with all passes takes too long in motion, or may. */
    get isSlow() {
      return this.whole === 0 || this.whole > SLOW;
    }
    /** Of the last motion; before that as the one frame at rest tells. */
    get framesPerSecond() {
      const time = this.intervals.length ? this.interval : this.whole;
      return time > 0 ? 1e3 / time : null;
    }
    get interval() {
      return this.intervals.reduce((sum, each) => sum + each, 0) / this.intervals.length;
    }
  };

  // src/viewer.ts
  var REST = 200;
  var STILL_TO_COME = "Views are still to come. Try again in a moment.";
  var Viewer = class {
    pace = new Pace();
    place;
    mode;
    motion;
    /** Milliseconds from when the page was opened until it drew. */
    firstDrawn = null;
    data;
    grid;
    store;
    told;
    engine = null;
    isDirty = false;
    asked = 0;
    isMoving = true;
    // so the first picture is quick, and the rest follows
    restTimer = 0;
    constructor(data, grid, store, place, mode, motion, told) {
      this.data = data;
      this.grid = grid;
      this.store = store;
      this.place = grid.within(place);
      this.mode = mode;
      this.motion = motion;
      this.told = told;
    }
    /** Draw with an engine from now on; without one nothing is drawn. */
    use(engine) {
      this.engine = engine;
      if (!engine) return;
      this.store.attach(engine);
      this.isMoving = true;
      this.ask();
    }
    turn(right, up) {
      this.go([this.place[0] + right, this.place[1] + up]);
    }
    go(place) {
      this.place = this.grid.within(place);
      this.isMoving = true;
      clearTimeout(this.restTimer);
      this.ask();
    }
    choose(mode, motion) {
      this.mode = mode;
      this.motion = motion;
      this.ask();
    }
    /** Draw a place at once with all passes, whatever the pace; views must be there. */
    drawNow(mode = this.mode) {
      const moment = this.moment(mode);
      if (!moment || !this.engine) throw new PageError(STILL_TO_COME);
      this.engine.draw(moment);
      return this.engine;
    }
    /** The fields that the picture of this place is voted from, and their weights; views must be there. */
    fields() {
      const moment = this.moment(this.mode);
      if (!moment || !this.engine) throw new PageError(STILL_TO_COME);
      const { engine, mode } = this;
      const found = framesOf(moment).map(({ order, weight }) => {
        engine.draw({ ...moment, mode: mode === "fade" ? "limited" : mode, around: order.map((k) => moment.around[k]) });
        return { pixels: engine.read(mode === "nnf" ? "shifted" : "searched").slice(), weight };
      });
      engine.draw(moment);
      return found;
    }
    /** The views that are needed here. */
    get needed() {
      return this.grid.around(this.place).map((neighbour) => neighbour.view);
    }
    ask() {
      if (this.isDirty) return;
      this.isDirty = true;
      this.asked = performance.now();
      requestAnimationFrame((now) => this.tried(() => this.frame(now)));
    }
    tried(step) {
      try {
        step();
      } catch (error) {
        this.told.fails(error);
      }
    }
    frame(now) {
      this.isDirty = false;
      if (!this.engine) return;
      const waits = this.isMoving && this.pace.isSlow && this.mode !== quick(this.mode);
      const moment = this.moment(waits ? quick(this.mode) : this.mode);
      if (!moment) {
        const needed = this.needed;
        this.store.arrived(needed).then(() => this.ask(), (error) => this.told.lacks(error));
        return;
      }
      this.told.waits(waits ? this.mode : null);
      this.engine.draw(moment);
      this.firstDrawn ??= performance.now();
      clearTimeout(this.restTimer);
      if (this.isMoving) {
        this.pace.moved(this.asked, now, performance.now(), !waits);
        this.restTimer = setTimeout(() => this.tried(() => this.rest(waits)), REST);
      }
      this.told.rate(this.pace.framesPerSecond);
    }
    /** What had to wait is drawn now, and how long it takes is remembered. */
    rest(hasWaited) {
      this.isMoving = false;
      if (!this.engine) return;
      const begun = performance.now();
      if (hasWaited) {
        this.drawNow();
        this.engine.finish();
        this.told.waits(null);
      }
      this.pace.rested(hasWaited ? performance.now() - begun : null);
      this.told.rate(this.pace.framesPerSecond);
      this.told.rests(this.place);
      this.store.prepare(this.grid.beyond(this.place)).catch(() => void 0);
    }
    moment(mode) {
      const around = this.grid.around(this.place);
      const slots = this.store.need(around.map((neighbour) => neighbour.view));
      if (!slots) return null;
      const { width, height, views } = this.data;
      const lens = (camera) => camera && lensOf(camera, width, height);
      return {
        mode,
        lens: lens(this.grid.hasCameras ? this.grid.camera(this.place) : null),
        around: around.map(({ view, linear, fading }, k) => ({ slot: slots[k], linear, fading, lens: lens(views[view].camera) })),
        step: STEPS[this.motion]
      };
    }
  };
  var quick = (mode) => mode === "limited" || mode === "fade" ? "nnf" : mode;

  // src/main.ts
  var MIDDLE = [0, 0];
  async function start(panel) {
    const data = readPageData();
    const parameters = readParameters(location.search);
    const { width, height, style } = data;
    const longest = Math.max(width, height, style?.width ?? 0, style?.height ?? 0);
    const engines = new Engines(panel.canvas, width, height, longest, parameters.engine);
    const source = sourceOf(data);
    const grid = new Grid(data);
    const [hasFields, hasModel] = [style !== null, (data.mesh !== null || hasPoints(data)) && grid.hasCameras];
    const isPossible = (mode2) => (hasFields || !needsFields(mode2)) && (hasModel || !needsModel(mode2));
    const best = ["fade", "image", "linear"].find(isPossible);
    const mode = parameters.mode && isPossible(parameters.mode) ? parameters.mode : best;
    if (parameters.mode && mode !== parameters.mode)
      parameters.strange.push(`The address asks for mode=${parameters.mode}, and this page has no data for it.`);
    panel.tellRemark(parameters.strange.join(" "));
    const store = new Store(data, source);
    const fail = (error) => panel.say(sentence(error));
    const warn = (error) => panel.tellWaiting(sentence(error));
    const viewer = new Viewer(data, grid, store, parameters.view ?? MIDDLE, mode, parameters.motion, {
      rests: (place) => panel.tellView(placeText(place, data)),
      rate: (framesPerSecond) => panel.tellRate(framesPerSecond),
      waits: (waiting) => panel.tellWaiting(waiting ? "Limited search waits until the drawing rests." : ""),
      lacks: warn,
      fails: fail
    });
    let whole = null;
    engines.onRestored(() => viewer.use(null), () => whole && viewer.use(engines.make(whole)));
    const [stage] = await Promise.all([readStage(data, source), store.arrived(viewer.needed)]);
    panel.offer(hasFields, hasModel, mode, parameters.motion, {
      mode: (chosen2) => viewer.choose(chosen2, viewer.motion),
      motion: (chosen2) => viewer.choose(viewer.mode, chosen2),
      save: () => void save(panel, viewer, data, stage, source).catch(warn)
    });
    control(panel.canvas, grid, { by: (right, up) => viewer.turn(right, up), home: () => viewer.go(MIDDLE) });
    panel.say("");
    whole = stage;
    viewer.use(engines.make(stage));
    window.stylitViewer = { viewer, store, engines };
  }
  var hasPoints = (data) => data.views.every((view) => view.points !== null);
  async function readStage(data, source) {
    const { width, height, patchRadius, reach, style, mesh } = data;
    const bytes = (piece) => piece && decode(piece.piece, source);
    const [colours, triangles] = await Promise.all([bytes(style), bytes(mesh)]);
    return {
      width,
      height,
      patchRadius,
      reach,
      style: style && colours && { width: style.width, height: style.height, rgba: toRgba(colours) },
      mesh: mesh && triangles && meshOf(mesh, triangles),
      hasPoints: hasPoints(data),
      slots: Math.min(SLOTS, data.views.length)
    };
  }
  async function save(panel, viewer, data, stage, source) {
    let canvas = panel.canvas;
    if (data.still && data.style && needsFields(viewer.mode)) {
      const { scale, piece } = data.still;
      const fields = viewer.fields();
      const style = { scale, width: scale * data.style.width, rgba: toRgba(await decode(piece, source)) };
      const image = mixed(
        fields.map((field) => replay(field.pixels, stage.width, stage.height, stage.patchRadius, style)),
        fields.map((field) => field.weight)
      );
      canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
      canvas.getContext("2d")?.putImageData(image, 0, 0);
    } else viewer.drawNow();
    const blob = await new Promise((resolve) => canvas.toBlob(resolve));
    if (!blob) throw new PageError("The still is too large for this browser. Save it in another one.");
    panel.download(blob, "still.png");
  }
  function placeText([right, up], { columns }) {
    const told = (value, way, back) => `${Math.abs(value).toFixed(2)} ${columns.unit} ${value < 0 ? back : way}`;
    return `${told(right, "to the right", "to the left")} and ${told(up, "up", "down")}`;
  }
  function sentence(error) {
    if (error instanceof PageError) return error.message;
    console.error(error);
    return `The drawing cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
  }
  document.addEventListener("DOMContentLoaded", () => {
    const panel = new Panel();
    start(panel).catch((error) => panel.say(sentence(error)));
  });
})();
