"use strict";
(() => {
  // src/pixels.ts
  var OPAQUE = 4278190080;
  var pack = (red, green, blue) => (OPAQUE | blue << 16 | green << 8 | red) >>> 0;
  function fromRgb(rgb, pixels) {
    for (let from = 0, to = 0; to < pixels.length; from += 3, to++)
      pixels[to] = OPAQUE | rgb[from + 2] << 16 | rgb[from + 1] << 8 | rgb[from];
  }

  // src/rect.ts
  function around(one, other) {
    if (!one || !other) return one ?? other;
    const x = Math.min(one.x, other.x);
    const y = Math.min(one.y, other.y);
    const right = Math.max(one.x + one.width, other.x + other.width);
    const bottom = Math.max(one.y + one.height, other.y + other.height);
    return { x, y, width: right - x, height: bottom - y };
  }
  function within(rect, frame) {
    const x = Math.max(rect.x, frame.x);
    const y = Math.max(rect.y, frame.y);
    const width = Math.min(rect.x + rect.width, frame.x + frame.width) - x;
    const height = Math.min(rect.y + rect.height, frame.y + frame.height) - y;
    return width > 0 && height > 0 ? { x, y, width, height } : null;
  }

  // src/painting.ts
  var TILE = 64;
  var Painting = class {
    width;
    height;
    /** One opaque pixel a number; see pixels.ts. */
    pixels;
    /** Tiles in a row of them. */
    columns;
    image;
    context;
    unshown = null;
    constructor(canvas, width, height) {
      Object.assign(canvas, { width, height });
      this.width = width;
      this.height = height;
      this.columns = Math.ceil(width / TILE);
      this.image = new ImageData(width, height);
      this.pixels = new Uint32Array(this.image.data.buffer);
      this.pixels.fill(4294967295);
      this.context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
      this.context.putImageData(this.image, 0, 0);
    }
    get whole() {
      return { x: 0, y: 0, width: this.width, height: this.height };
    }
    /** The numbers of the tiles that a rectangle touches. */
    *tilesOf(rect) {
      const right = Math.floor((rect.x + rect.width - 1) / TILE);
      const bottom = Math.floor((rect.y + rect.height - 1) / TILE);
      for (let y = Math.floor(rect.y / TILE); y <= bottom; y++)
        for (let x = Math.floor(rect.x / TILE); x <= right; x++) yield y * this.columns + x;
    }
    frameOf(tile) {
      const place = { x: tile % this.columns * TILE, y: Math.floor(tile / this.columns) * TILE };
      return within({ ...place, width: TILE, height: TILE }, this.whole);
    }
    copyTile(tile) {
      const { x, y, width, height } = this.frameOf(tile);
      const copy = new Uint32Array(TILE * TILE);
      for (let row = 0; row < height; row++) {
        const from = (y + row) * this.width + x;
        copy.set(this.pixels.subarray(from, from + width), row * TILE);
      }
      return copy;
    }
    writeTile(tile, copy) {
      const frame = this.frameOf(tile);
      for (let row = 0; row < frame.height; row++)
        this.pixels.set(copy.subarray(row * TILE, row * TILE + frame.width), (frame.y + row) * this.width + frame.x);
      this.changed(frame);
      return frame;
    }
    /** All of it, three bytes a pixel. */
    replace(rgb) {
      fromRgb(rgb, this.pixels);
      this.changed(this.whole);
    }
    /** A rectangle, three bytes a pixel. */
    read({ x, y, width, height }) {
      const rgb = new Uint8Array(3 * width * height);
      let to = 0;
      for (let row = y; row < y + height; row++)
        for (let at = row * this.width + x, end = at + width; at < end; at++) {
          const pixel = this.pixels[at];
          rgb[to++] = pixel & 255;
          rgb[to++] = pixel >> 8 & 255;
          rgb[to++] = pixel >> 16 & 255;
        }
      return rgb;
    }
    /** The pixel at a place; null outside. */
    at(x, y) {
      const [column, row] = [Math.floor(x), Math.floor(y)];
      const isInside = column >= 0 && row >= 0 && column < this.width && row < this.height;
      return isInside ? this.pixels[row * this.width + column] : null;
    }
    /** Pixels differ; the canvas shows them once `show` is called. */
    changed(rect) {
      this.unshown = around(this.unshown, rect);
    }
    show() {
      if (!this.unshown) return;
      const { x, y, width, height } = this.unshown;
      this.context.putImageData(this.image, 0, 0, x, y, width, height);
      this.unshown = null;
    }
  };

  // src/history.ts
  var MOST_BYTES = 256 * 1024 * 1024;
  var MOST_STEPS = 100;
  var TILE_BYTES = 4 * TILE * TILE;
  var History = class {
    most;
    undoable = [];
    redoable = [];
    /** Keeps so many bytes at most; the oldest changes give way. */
    constructor(most = MOST_BYTES) {
      this.most = most;
    }
    get canUndo() {
      return this.undoable.length > 0;
    }
    get canRedo() {
      return this.redoable.length > 0;
    }
    get bytes() {
      return [...this.undoable, ...this.redoable].reduce((sum, tiles) => sum + tiles.size, 0) * TILE_BYTES;
    }
    /** A change has been made; `before` is what it changed. */
    add(before) {
      if (!before.size) return;
      this.redoable = [];
      this.undoable.push(before);
      while (this.bytes > this.most || this.undoable.length > MOST_STEPS) this.undoable.shift();
    }
    /** Take the last change back; where the painting differs now, or null. */
    undo(painting) {
      return swap(painting, this.undoable, this.redoable);
    }
    redo(painting) {
      return swap(painting, this.redoable, this.undoable);
    }
  };
  function swap(painting, from, to) {
    const tiles = from.pop();
    if (!tiles) return null;
    let changed2 = null;
    for (const [tile, copy] of tiles) {
      tiles.set(tile, painting.copyTile(tile));
      changed2 = around(changed2, painting.writeTile(tile, copy));
    }
    to.push(tiles);
    return changed2;
  }

  // src/brush.ts
  var LONGEST = 3;
  function dabOf(brush, sample, direction) {
    const { x, y, pressure, lean, azimuth } = sample;
    const shaped = brush.pressure === "size" || brush.pressure === "both" ? 0.08 + 0.92 * pressure : 1;
    const strength = brush.pressure === "opacity" || brush.pressure === "both" ? pressure : 1;
    const length = brush.tilts ? 1 + (LONGEST - 1) * lean * lean : 1;
    const radius = Math.max(brush.size / 2 * shaped, 0.4);
    return { x, y, radius: radius * Math.sqrt(length), aspect: 1 / length, angle: azimuth, direction, strength };
  }
  var spacingOf = (dab) => Math.max(0.5, 0.16 * dab.radius * dab.aspect);
  function profileOf(hardness, radius) {
    const core = Math.max(0, Math.min(hardness, 1 - 1 / Math.max(radius, 1)));
    return Uint8Array.from({ length: 257 }, (_, k) => {
      const way = (1 - Math.sqrt(k / 256)) / (1 - core);
      const t = Math.min(Math.max(way, 0), 1);
      return Math.round(255 * t * t * (3 - 2 * t));
    });
  }

  // src/path.ts
  var STRING = 1;
  var STRING_PIXELS = 24;
  var CHORD = 1;
  var Path = class {
    brush;
    string;
    /** Where the brush is. */
    held;
    pen;
    /** Where the curve has come to, and the last mark. */
    end;
    direction = 0;
    sinceDab = Infinity;
    spacing = 0;
    constructor(brush, start2) {
      this.brush = brush;
      this.string = brush.smoothing * (STRING * brush.size + STRING_PIXELS);
      this.held = this.pen = this.end = start2;
    }
    /** The mark where it begins. */
    *begin() {
      if (this.brush.grain !== "bristles") yield* this.mark(this.end);
    }
    *move(pen) {
      this.pen = pen;
      const [x, y] = [pen.x - this.held.x, pen.y - this.held.y];
      const distance = Math.hypot(x, y);
      if (distance <= this.string || distance === 0) return;
      const pulled = (distance - this.string) / distance;
      const next = { ...pen, x: this.held.x + pulled * x, y: this.held.y + pulled * y };
      yield* this.curve(this.held, mixed(this.held, next, 0.5));
      this.held = next;
    }
    *finish() {
      yield* this.curve(this.held, this.pen);
      if (this.sinceDab === Infinity) yield* this.mark(this.end);
    }
    /** A quadratic curve from where it has come to. */
    *curve(control, to) {
      const from = this.end;
      const length = Math.hypot(control.x - from.x, control.y - from.y) + Math.hypot(to.x - control.x, to.y - control.y);
      const chords = Math.ceil(length / CHORD);
      for (let k = 1; k <= chords; k++) {
        const t = k / chords;
        yield* this.line(mixed(mixed(from, control, t), mixed(control, to, t), t));
      }
    }
    *line(to) {
      const from = this.end;
      const length = Math.hypot(to.x - from.x, to.y - from.y);
      if (length === 0) return;
      this.direction = Math.atan2(to.y - from.y, to.x - from.x);
      if (this.sinceDab === Infinity) yield* this.mark(from);
      for (let done = 0; ; ) {
        const left = Math.max(0, this.spacing - this.sinceDab);
        if (done + left > length) {
          this.sinceDab += length - done;
          break;
        }
        done += left;
        yield* this.mark(mixed(from, to, done / length));
      }
      this.end = to;
    }
    *mark(sample) {
      const dab = dabOf(this.brush, sample, this.direction);
      this.spacing = spacingOf(dab);
      this.sinceDab = 0;
      yield dab;
    }
  };
  function mixed(one, other, part) {
    const mix = (a, b) => a + (b - a) * part;
    return {
      x: mix(one.x, other.x),
      y: mix(one.y, other.y),
      pressure: mix(one.pressure, other.pressure),
      lean: mix(one.lean, other.lean),
      azimuth: other.azimuth
    };
  }

  // src/grains.ts
  var GRAINS = {
    smooth: "Smooth",
    paper: "Paper",
    canvas: "Canvas",
    speckle: "Speckle",
    bristles: "Bristles"
  };
  var GRAIN = 128;
  var HAIRS = 64;
  var made = /* @__PURE__ */ new Map();
  function grainOf(name) {
    if (!made.has(name)) made.set(name, make(name));
    return made.get(name);
  }
  function make(name) {
    if (name === "smooth") return null;
    if (name === "bristles") return { follows: "stroke", fill: 1.6, heights: levelled(hairs()) };
    const height = { paper: paperAt, canvas: weaveAt, speckle: speckleAt }[name];
    const heights = Float32Array.from({ length: GRAIN * GRAIN }, (_, k) => height(k % GRAIN, Math.floor(k / GRAIN)));
    return { follows: "ground", fill: 3, heights: levelled(heights) };
  }
  var paperAt = (x, y) => 0.5 * noise(x, y, 2, 1) + 0.35 * noise(x, y, 4, 2) + 0.15 * noise(x, y, 1, 3);
  var speckleAt = (x, y) => noise(x, y, 1, 4) + 0.4 * noise(x, y, 8, 5);
  function weaveAt(x, y) {
    const thread = 2 * Math.PI / 8;
    const [across, along] = [Math.sin(thread * x), Math.sin(thread * y)];
    return Math.max(across * Math.sign(along), along * Math.sign(-across)) + 0.5 * noise(x, y, 2, 6);
  }
  var hairs = () => Float32Array.from({ length: HAIRS }, (_, k) => noise(k, 0, 1, 7) + noise(k, 0, 4, 8));
  function noise(x, y, size, seed) {
    const cells = GRAIN / size;
    const [left, top] = [Math.floor(x / size), Math.floor(y / size)];
    const [right, down] = [ease(x / size - left), ease(y / size - top)];
    const at = (column, row) => random(column % cells + cells * (row % cells), seed);
    const upper = at(left, top) * (1 - right) + at(left + 1, top) * right;
    const lower = at(left, top + 1) * (1 - right) + at(left + 1, top + 1) * right;
    return upper * (1 - down) + lower * down;
  }
  var ease = (t) => t * t * (3 - 2 * t);
  function random(place, seed) {
    let mixed3 = Math.imul(place + 1, 2654435761) ^ Math.imul(seed, 2246822507);
    mixed3 = Math.imul(mixed3 ^ mixed3 >>> 15, 739982445);
    mixed3 = Math.imul(mixed3 ^ mixed3 >>> 12, 695872825);
    return ((mixed3 ^ mixed3 >>> 15) >>> 0) / 2 ** 32;
  }
  function levelled(heights) {
    const order = [...heights.keys()].sort((a, b) => heights[a] - heights[b]);
    const ranks = new Uint8Array(heights.length);
    order.forEach((place, rank) => ranks[place] = Math.floor(256 * rank / heights.length));
    return ranks;
  }

  // src/stroke.ts
  var Stroke = class {
    painting;
    ink;
    brush;
    grain;
    touched = /* @__PURE__ */ new Map();
    profile = new Uint8Array(0);
    profileRadius = 0;
    constructor(painting, ink, brush) {
      this.painting = painting;
      this.ink = ink;
      this.brush = { ...brush };
      this.grain = grainOf(brush.grain);
    }
    /** What the tiles held before. */
    get before() {
      return new Map([...this.touched].map(([tile, { before }]) => [tile, before]));
    }
    /** Take it all back; where the painting differs now. */
    cancel() {
      let changed2 = null;
      for (const [tile, before] of this.before) changed2 = around(changed2, this.painting.writeTile(tile, before));
      return changed2;
    }
    /** Leave a mark; where the painting differs now. */
    add(dab) {
      const reach = dab.radius + 1;
      const [x, y] = [Math.floor(dab.x - reach), Math.floor(dab.y - reach)];
      const square = { x, y, width: Math.ceil(dab.x + reach) - x, height: Math.ceil(dab.y + reach) - y };
      const rect = within(square, this.painting.whole);
      if (!rect) return null;
      if (Math.abs(this.profileRadius / dab.radius - 1) > 0.05) {
        this.profile = profileOf(this.brush.hardness, dab.radius * dab.aspect);
        this.profileRadius = dab.radius;
      }
      for (const tile of this.painting.tilesOf(rect)) this.addTo(tile, rect, dab);
      this.painting.changed(rect);
      return rect;
    }
    addTo(tile, rect, dab) {
      const frame = this.painting.frameOf(tile);
      const part = within(rect, frame);
      const { before, covered } = this.touch(tile);
      const { pixels, width } = this.painting;
      const { ink, profile, grain } = this;
      const radius = dab.radius + 0.5;
      const [cos, sin] = [Math.cos(dab.angle) / radius, Math.sin(dab.angle) / radius];
      const [along, across] = [Math.cos(dab.direction) / radius, Math.sin(dab.direction) / radius];
      const opacity = this.brush.opacity;
      for (let y = part.y; y < part.y + part.height; y++) {
        const down = y + 0.5 - dab.y;
        let at = (y - frame.y) * TILE + part.x - frame.x;
        for (let x = part.x; x < part.x + part.width; x++, at++) {
          const right = x + 0.5 - dab.x;
          const major = right * cos + down * sin;
          const minor = (down * cos - right * sin) / dab.aspect;
          const square = major * major + minor * minor;
          if (square >= 1) continue;
          let paint = profile[Math.floor(256 * square)] * dab.strength;
          if (grain) {
            const hair = (down * along - right * across + 1) * (HAIRS / 2);
            const place = grain.follows === "ground" ? y % GRAIN * GRAIN + x % GRAIN : Math.min(Math.max(Math.floor(hair), 0), HAIRS - 1);
            paint = Math.min(255, Math.max(0, grain.fill * (paint + grain.heights[place] - 255)));
          }
          if (paint <= covered[at]) continue;
          covered[at] = paint;
          const from = ink.pixels[y % ink.height * ink.width + x % ink.width];
          pixels[y * width + x] = mixed2(before[at], from, covered[at] * opacity / 255);
        }
      }
    }
    touch(tile) {
      let touched = this.touched.get(tile);
      if (!touched) {
        touched = { before: this.painting.copyTile(tile), covered: new Uint8Array(TILE * TILE) };
        this.touched.set(tile, touched);
      }
      return touched;
    }
  };
  function mixed2(below, above, part) {
    const red = (below & 255) + ((above & 255) - (below & 255)) * part;
    const green = (below >> 8 & 255) + ((above >> 8 & 255) - (below >> 8 & 255)) * part;
    const blue = (below >> 16 & 255) + ((above >> 16 & 255) - (below >> 16 & 255)) * part;
    return 4278190080 | Math.round(blue) << 16 | Math.round(green) << 8 | Math.round(red);
  }

  // src/artist.ts
  var PAPER = { width: 1, height: 1, pixels: Uint32Array.of(4294967295) };
  var Artist = class {
    history = new History();
    /** What the painting began with. */
    beginning = PAPER;
    texture = null;
    /** Whether the page may paint; a reader may not. */
    mayPaint = false;
    settings;
    sender;
    /** Called whenever undo and redo may have become possible or not. */
    tell;
    painting = null;
    stroke = null;
    path = null;
    constructor(settings, sender, tell) {
      this.settings = settings;
      this.sender = sender;
      this.tell = tell;
    }
    /** Work on a painting, which has no history yet. */
    use(painting) {
      this.painting = this.sender.painting = painting;
      this.beginning = PAPER;
      this.stroke = this.path = null;
      this.forget();
    }
    /** Nothing that was painted can be undone. */
    forget() {
      this.history = new History();
      this.tell();
    }
    get isPainting() {
      return this.stroke !== null;
    }
    begin(sample, time) {
      if (!this.mayPaint || !this.painting) return;
      this.end();
      const { brush, rgb, tool } = this.settings.chosen;
      if (tool !== "eraser" && !this.paintsTexture) this.settings.used(rgb);
      this.stroke = new Stroke(this.painting, this.ink, brush);
      this.path = new Path(brush, sample);
      this.add(this.path.begin(), time);
    }
    /** Go on to places, one after the other. */
    move(samples, time) {
      const { path } = this;
      if (path) this.add(samples.flatMap((sample) => [...path.move(sample)]), time);
    }
    end(time) {
      if (!this.stroke || !this.path) return;
      this.add(this.path.finish(), time);
      this.history.add(this.stroke.before);
      this.stroke = this.path = null;
      this.sender.rest();
      this.tell();
    }
    /** It was no stroke: a second finger came. */
    cancel() {
      if (!this.stroke) return;
      this.sender.changed(this.stroke.cancel());
      this.stroke = this.path = null;
      this.sender.rest();
    }
    undo() {
      this.turnBack((painting) => this.history.undo(painting));
    }
    redo() {
      this.turnBack((painting) => this.history.redo(painting));
    }
    /** Take over a painting from elsewhere; it can be undone. */
    replace(rgb) {
      const painting = this.painting;
      this.cancel();
      this.history.add(new Map([...painting.tilesOf(painting.whole)].map((tile) => [tile, painting.copyTile(tile)])));
      painting.replace(rgb);
      this.tell();
    }
    turnBack(turn) {
      if (!this.mayPaint || !this.painting) return;
      this.end();
      this.sender.changed(turn(this.painting));
      this.sender.rest();
      this.tell();
    }
    add(dabs, time) {
      let changed2 = null;
      for (const dab of dabs) changed2 = around(changed2, this.stroke.add(dab));
      this.sender.changed(changed2, time);
    }
    get paintsTexture() {
      return this.settings.chosen.usesTexture && this.texture !== null;
    }
    get ink() {
      const { tool, rgb, erasesTo } = this.settings.chosen;
      if (tool === "eraser") return erasesTo === "beginning" ? this.beginning : PAPER;
      if (this.paintsTexture) return this.texture;
      return { width: 1, height: 1, pixels: Uint32Array.of(pack(...rgb)) };
    }
  };

  // src/protocol.ts
  var VERSION = 2;
  var RESULTS = ["replay", "coherent", "warm", "fast", "full", "step", "look"];
  var RECT_HEAD = 14;
  var FRAME_HEAD = 16;
  var [PAINTING, CHANGES] = [2, 3];
  var TILE2 = 16;
  function rectMessage(rect, serial, rgb) {
    const message = new Uint8Array(RECT_HEAD + rgb.length);
    const head = new DataView(message.buffer);
    head.setUint8(0, 1);
    [rect.x, rect.y, rect.width, rect.height].forEach((value, k) => head.setUint16(2 + 2 * k, value, true));
    head.setUint32(10, serial, true);
    message.set(rgb, RECT_HEAD);
    return message;
  }
  function readFrame(message, before) {
    if (message.byteLength < FRAME_HEAD) return null;
    const head = new DataView(message);
    const [kind, which] = [head.getUint8(0), RESULTS[head.getUint8(1)]];
    const [width, height] = [head.getUint16(2, true), head.getUint16(4, true)];
    const begins = FRAME_HEAD + head.getUint16(6, true);
    if (message.byteLength < begins) return null;
    const of = new TextDecoder().decode(message.slice(FRAME_HEAD, begins));
    const body = new Uint8Array(message, begins);
    const rgb = kind === CHANGES ? changed(body, before) : body;
    if (!which || rgb?.length !== 3 * width * height) return null;
    const [serial, milliseconds] = [head.getUint32(8, true), head.getFloat32(12, true)];
    return { isPainting: kind === PAINTING, which, width, height, serial, milliseconds, of, rgb };
  }
  function changed(body, before) {
    if (!before) return null;
    const { width, height } = before;
    const [rows, columns] = [Math.ceil(height / TILE2), Math.ceil(width / TILE2)];
    const rgb = before.rgb.slice();
    let from = Math.ceil(rows * columns / 8);
    for (let tile = 0; tile < rows * columns; tile++) {
      if (!(body[tile >> 3] >> (tile & 7) & 1)) continue;
      const [x, y] = [tile % columns * TILE2, Math.floor(tile / columns) * TILE2];
      const length = 3 * Math.min(TILE2, width - x);
      for (let row = 0; row < TILE2; row++, from += 3 * TILE2)
        if (y + row < height) rgb.set(body.subarray(from, from + length), 3 * ((y + row) * width + x));
    }
    return rgb;
  }

  // src/connection.ts
  var FIRST_WAIT = 250;
  var LONGEST_WAIT = 4e3;
  var Connection = class {
    heard = null;
    socket = null;
    wait = FIRST_WAIT;
    /** The last picture that came. */
    picture = null;
    /** Whether the server has welcomed the page. */
    isOpen = false;
    /** Begin, and tell what is heard from now on. */
    begin(heard) {
      this.heard = heard;
      this.open();
    }
    /** Bytes that are on their way out. */
    get backlog() {
      return this.socket?.bufferedAmount ?? 0;
    }
    /** Whether it could be said. */
    ask(asked) {
      if (!this.isOpen) return false;
      this.socket?.send(JSON.stringify(asked));
      return true;
    }
    send(bytes) {
      this.socket?.send(bytes);
    }
    open() {
      const socket = new WebSocket(`ws://${location.host}/live`);
      this.socket = socket;
      this.picture = null;
      socket.binaryType = "arraybuffer";
      socket.onopen = () => socket.send(JSON.stringify({ do: "hello", version: VERSION }));
      socket.onmessage = ({ data }) => {
        if (typeof data !== "string") {
          const frame = readFrame(data, this.picture);
          if (frame && !frame.isPainting) this.picture = frame;
          if (frame) this.heard?.frame(frame);
          return;
        }
        const said = JSON.parse(data);
        if (said.say === "welcome") {
          this.isOpen = true;
          this.wait = FIRST_WAIT;
        }
        this.heard?.said(said);
      };
      socket.onclose = () => {
        this.isOpen = false;
        this.heard?.lost();
        setTimeout(() => this.open(), this.wait);
        this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
      };
    }
  };

  // src/pen.ts
  function sampleOf(event, place) {
    const isPen = event.pointerType === "pen";
    const [lean, azimuth] = isPen ? leanOf(event) : [0, 0];
    return { x: place[0], y: place[1], pressure: isPen ? event.pressure : 1, lean, azimuth };
  }
  function coalesced(event) {
    const events = "getCoalescedEvents" in event ? event.getCoalescedEvents() : [];
    return events.length ? events : [event];
  }
  function leanOf(event) {
    if (event.altitudeAngle !== void 0) return [1 - event.altitudeAngle / (Math.PI / 2), event.azimuthAngle];
    const [x, y] = [event.tiltX, event.tiltY].map((tilt) => Math.tan(Math.min(Math.max(tilt, -89), 89) * Math.PI / 180));
    return [Math.atan(Math.hypot(x, y)) / (Math.PI / 2), Math.atan2(y, x)];
  }

  // src/easel.ts
  function easel(viewport, artist, picker, settings, tip) {
    let picks = false;
    const placeOf = (event) => viewport.placeAt(event.clientX, event.clientY);
    const sample = (event) => sampleOf(event, placeOf(event));
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
      cancel: () => artist.cancel()
    };
  }

  // src/elements.ts
  var byId = (id) => document.getElementById(id);
  function made2(tag, properties = {}, ...held) {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...held);
    return element;
  }
  var takesLetters = (target) => target instanceof HTMLElement && target.matches("input:not([type=range], [type=checkbox], [type=radio]), select, textarea, iframe, dialog *");
  var takesSpace = (target) => target instanceof HTMLElement && target.matches("button, a, summary, input, select, textarea, iframe, dialog *");

  // src/exporting.ts
  var Exporting = class {
    dialog = byId("export-dialog");
    state = byId("export-state");
    constructor(connection, open) {
      open.onclick = () => {
        byId("export-done").hidden = true;
        const isAsked = connection.ask({ do: "export" });
        this.state.textContent = isAsked ? "The files are being written." : "Nothing can be exported while there is no connection.";
        this.dialog.showModal();
      };
    }
    tell({ folder, files, commands }) {
      this.state.textContent = `The files lie in ${folder}.`;
      byId("export-files").replaceChildren(
        ...files.map((file) => {
          const name = file.split(/[\\/]/).at(-1);
          return made2("li", {}, made2("a", { href: `/export/${encodeURIComponent(name)}`, download: name, textContent: name }));
        })
      );
      byId("export-commands").replaceChildren(...commands.map(commandOf));
      byId("export-done").hidden = false;
    }
    fail(text) {
      if (this.dialog.open && byId("export-done").hidden) this.state.textContent = text;
    }
  };
  function commandOf(command) {
    const text = made2("code", { textContent: command, tabIndex: 0 });
    const copy = made2("button", { type: "button", className: "small", textContent: "Copy" });
    copy.onclick = async () => {
      try {
        await navigator.clipboard.writeText(command);
        copy.textContent = "Copied";
      } catch {
        getSelection()?.selectAllChildren(text);
        copy.textContent = "Selected";
      }
    };
    return made2("li", { className: "command" }, text, copy);
  }

  // src/frames.ts
  function oncePerFrame(step) {
    let isAsked = false;
    return () => {
      if (isAsked) return;
      isAsked = true;
      requestAnimationFrame(() => {
        isAsked = false;
        step();
      });
    };
  }
  function atOnceAndPerFrame(step) {
    let [isAsked, hasStepped] = [false, false];
    const take = () => {
      hasStepped = true;
      requestAnimationFrame(() => {
        hasStepped = false;
        if (isAsked) take();
      });
      isAsked = false;
      step();
    };
    return () => {
      if (hasStepped) isAsked = true;
      else take();
    };
  }

  // src/guides.ts
  var HEAVIEST = 8;
  var Guides = class {
    connection;
    unsent = {};
    picked = /* @__PURE__ */ new Set();
    askFrame;
    constructor(connection) {
      this.connection = connection;
      this.askFrame = oncePerFrame(() => {
        this.connection.ask({ do: "weights", values: this.unsent });
        this.unsent = {};
      });
    }
    offer(scene, weights, picked) {
      const names = [.../* @__PURE__ */ new Set([...scene.layers, ...scene.buffers])];
      this.picked = new Set(picked.length ? picked : scene.buffers);
      byId("guides").replaceChildren(...names.map((name) => this.row(scene, name, weights[name] ?? 1)));
    }
    row(scene, name, weight) {
      const address = (side) => `/thumb/${[scene.name, side, name].map(encodeURIComponent).join("/")}`;
      const thumb = (side) => made2("img", { src: address(side), alt: "", loading: "lazy", className: "thumb" });
      const shown = made2("output", { textContent: String(weight) });
      const slider = made2("input", { type: "range", min: "0", max: String(HEAVIEST), value: String(weight), ariaLabel: `Weight of ${name}` });
      slider.oninput = () => {
        shown.textContent = slider.value;
        this.unsent[name] = slider.valueAsNumber;
        this.askFrame();
      };
      const row = made2("li", {}, thumb("A"), thumb("B"), this.named(scene, name, slider), slider, shown);
      return row;
    }
    /** The name; with a box where one can choose. */
    named(scene, name, slider) {
      const text = made2("span", { className: "name", textContent: name });
      if (!scene.layers.includes(name)) return text;
      const box = made2("input", { type: "checkbox", checked: this.picked.has(name) });
      slider.disabled = !box.checked;
      box.onchange = () => {
        if (box.checked) this.picked.add(name);
        else if (this.picked.size > 1) this.picked.delete(name);
        else box.checked = true;
        slider.disabled = !box.checked;
        this.connection.ask({ do: "layers", names: [...this.picked] });
      };
      return made2("label", { className: "name" }, box, text);
    }
  };

  // src/hands.ts
  var space = { isDown: false, hasMoved: false };
  addEventListener("keydown", (event) => {
    if (event.key !== " " || takesSpace(event.target)) return;
    if (!event.repeat) space.hasMoved = false;
    space.isDown = true;
    document.body.classList.add("moves");
    event.preventDefault();
  });
  var release = () => {
    space.isDown = false;
    document.body.classList.remove("moves");
  };
  addEventListener("keyup", (event) => event.key === " " && release());
  addEventListener("blur", release);
  var Hands = class {
    viewport;
    drag;
    places = /* @__PURE__ */ new Map();
    way = null;
    leader = -1;
    /** Once a pen has touched the pane a lone finger moves it: the palm does not paint. */
    hasPen = false;
    constructor(viewport, drag) {
      this.viewport = viewport;
      this.drag = drag;
      const { pane } = viewport;
      pane.addEventListener("pointerdown", (event) => this.down(event));
      const moves = "onpointerrawupdate" in pane ? "pointerrawupdate" : "pointermove";
      pane.addEventListener(moves, (event) => this.move(event));
      for (const kind of ["pointerup", "pointercancel", "lostpointercapture"])
        pane.addEventListener(kind, (event) => this.up(event));
      pane.addEventListener("contextmenu", (event) => event.preventDefault());
    }
    down(event) {
      const isTouch = event.pointerType === "touch";
      if (event.button > 1 || this.way && !(isTouch && this.places.size === 1)) return;
      this.hasPen ||= event.pointerType === "pen";
      this.viewport.pane.setPointerCapture(event.pointerId);
      this.places.set(event.pointerId, [event.clientX, event.clientY]);
      if (this.places.size === 2) {
        if (this.way === "drag") this.drag.cancel();
        this.way = "pinch";
        return;
      }
      this.leader = event.pointerId;
      const moves = event.button === 1 || space.isDown || isTouch && this.hasPen;
      this.way = !moves && this.drag.begin(event) ? "drag" : "pan";
      if (event.button === 1) event.preventDefault();
    }
    move(event) {
      const before = this.places.get(event.pointerId);
      if (!before) return;
      const [right, down] = [event.clientX - before[0], event.clientY - before[1]];
      if (this.way === "drag") this.drag.move(event);
      else if (this.way === "pan") {
        space.hasMoved ||= space.isDown;
        this.viewport.pan(right, down);
      } else if (this.way === "pinch") {
        const other = [...this.places].find(([id]) => id !== event.pointerId)?.[1];
        if (other) {
          const span = (x2, y2) => Math.max(Math.hypot(x2 - other[0], y2 - other[1]), 1);
          const [x, y] = [event.clientX, event.clientY];
          this.viewport.pan(right / 2, down / 2);
          this.viewport.zoom(span(x, y) / span(...before), (x + other[0]) / 2, (y + other[1]) / 2);
        }
      }
      this.places.set(event.pointerId, [event.clientX, event.clientY]);
    }
    up(event) {
      if (!this.places.delete(event.pointerId)) return;
      if (this.way === "drag" && event.pointerId === this.leader) {
        if (event.type === "pointercancel") this.drag.cancel();
        else this.drag.end(event);
      }
      if (!this.places.size) this.way = null;
    }
  };

  // src/keyboard_hand.ts
  var ARROWS = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, -1],
    ArrowDown: [0, 1]
  };
  var KeyboardHand = class {
    painting = null;
    artist;
    picker;
    settings;
    tip;
    notices;
    place = null;
    isDown = false;
    constructor(pane, artist, picker, settings, tip, notices) {
      this.artist = artist;
      this.picker = picker;
      this.settings = settings;
      this.tip = tip;
      this.notices = notices;
      pane.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.metaKey) return;
        const arrow = ARROWS[event.key];
        if (arrow) this.move(arrow, event);
        else if (event.key === "Enter") this.press();
        else if (event.key === "Escape") this.lift();
        else return;
        event.preventDefault();
      });
      pane.addEventListener("keyup", (event) => event.key === " " && !space.hasMoved && this.press());
      pane.addEventListener("pointerdown", () => this.leave());
      pane.addEventListener("blur", () => this.leave());
    }
    move([right, down], event) {
      if (!this.painting) return;
      const { width, height } = this.painting;
      const [x, y] = this.place ?? [width / 2, height / 2];
      const step = event.altKey ? 1 : Math.max(1, Math.round(this.settings.chosen.brush.size / 4)) * (event.shiftKey ? 8 : 1);
      const kept = (value, most) => Math.min(Math.max(value, 0), most - 1);
      this.place = [kept(x + right * step, width), kept(y + down * step, height)];
      this.tip.showAt(...this.place);
      if (this.isDown) this.artist.move([this.sample], event.timeStamp);
    }
    press() {
      if (!this.painting) return;
      this.place ??= [this.painting.width / 2, this.painting.height / 2];
      this.tip.showAt(...this.place);
      if (this.settings.chosen.tool === "picker") {
        this.picker.pick(...this.place);
        this.picker.done();
      } else if (this.isDown) this.lift();
      else if (this.artist.mayPaint && this.settings.chosen.tool !== "hand") {
        this.isDown = true;
        this.artist.begin(this.sample);
        this.notices.say("The brush is down. Arrow keys draw; Space lifts it.");
      }
    }
    lift() {
      if (!this.isDown) return;
      this.isDown = false;
      this.artist.end();
      this.notices.say("The brush is lifted.");
    }
    leave() {
      this.lift();
      if (this.place) this.tip.hide();
      this.place = null;
    }
    get sample() {
      const [x, y] = this.place;
      return { x, y, pressure: 1, lean: 0, azimuth: 0 };
    }
  };

  // src/latency.ts
  var MOST = 2e3;
  var Latency = class {
    times = [];
    moved = /* @__PURE__ */ new Map();
    rested = /* @__PURE__ */ new Map();
    /** A rectangle is sent; `time` is when the pointer made the first of it. */
    sends(serial, time) {
      this.moved.set(serial, time);
      this.rested.clear();
    }
    rests(serial) {
      this.rested.set(serial, performance.now());
    }
    /** A picture has been drawn for the next frame. Paint is answered by the first that shows it, of whatever kind. */
    shows(which, serial) {
      requestAnimationFrame(() => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => {
          port1.close();
          this.answer("replay", this.moved, serial);
          if (which !== "replay") this.answer("coherent", this.rested, serial);
          this.times.splice(0, this.times.length - MOST);
        };
        port2.postMessage(null);
      });
    }
    answer(which, asked, serial) {
      const now = performance.now();
      for (const [known, time] of asked) {
        if (known > serial) continue;
        asked.delete(known);
        this.times.push({ which, serial: known, milliseconds: now - time });
      }
    }
  };

  // src/screen.ts
  var Screen = class {
    canvas;
    context;
    image = new ImageData(1, 1);
    constructor(canvas) {
      this.canvas = canvas;
      this.context = canvas.getContext("2d", { alpha: false });
    }
    show(width, height, rgb) {
      if (this.image.width !== width || this.image.height !== height) {
        this.image = new ImageData(width, height);
        Object.assign(this.canvas, { width, height });
        const { clientWidth } = this.canvas.parentElement;
        this.canvas.classList.toggle("squares", 1.5 * width < clientWidth);
      }
      fromRgb(rgb, new Uint32Array(this.image.data.buffer));
      this.context.putImageData(this.image, 0, 0);
    }
  };

  // src/looks.ts
  var isStill = (what) => what.startsWith("A:") || what.startsWith("B:");
  var Look = class {
    choice;
    canvas;
    screen;
    caption;
    constructor(side, chosen) {
      this.choice = byId(`${side}-look-choice`);
      this.canvas = byId(`${side}-look`);
      this.screen = new Screen(this.canvas);
      this.caption = byId(`${side}-looked`);
      byId(`${side}-look-away`).onclick = () => this.leave();
      const strength = byId(`${side}-look-strength`);
      this.choice.onchange = () => chosen(this);
      strength.oninput = () => this.canvas.style.opacity = String(strength.valueAsNumber / 100);
    }
    get what() {
      return this.choice.value;
    }
    offer(groups) {
      const { what } = this;
      this.choice.replaceChildren(
        new Option("Nothing", ""),
        ...Object.entries(groups).map(
          ([label, options]) => made2("optgroup", { label }, ...Object.entries(options).map(([value, text]) => new Option(text, value)))
        )
      );
      this.choice.value = what;
      if (!this.choice.value) this.choice.value = "";
      if (!this.what) this.hide();
    }
    hide() {
      this.canvas.hidden = this.caption.hidden = true;
    }
    leave() {
      this.choice.value = "";
      this.hide();
    }
    draw({ width, height, rgb }) {
      this.screen.show(width, height, rgb);
      this.caption.firstElementChild.textContent = this.choice.selectedOptions[0].text;
      this.canvas.hidden = this.caption.hidden = false;
    }
  };
  var Looks = class {
    connection;
    looks;
    waiting = /* @__PURE__ */ new Set();
    /** What the server has not answered yet; it is not asked again before. */
    asked = /* @__PURE__ */ new Set();
    constructor(connection) {
      this.connection = connection;
      this.looks = ["painting", "picture"].map((side) => new Look(side, (look) => this.want(look)));
    }
    offer({ buffers }, levels) {
      const [painting, picture] = this.looks;
      const named = (side) => Object.fromEntries(buffers.map((name) => [`${side}:${name}`, name]));
      const texts = Array.from({ length: levels }, (_, level) => [`level:${level}`, `Level ${level}`]);
      painting.offer({
        "Guides of A": named("A"),
        "What is made of it": { usage: "Heat map of use", style: "A\u2032 as it is used" }
      });
      picture.offer({
        "Guides of B": named("B"),
        "What lies between": { nnf: "Matches (NNF)", ...Object.fromEntries(texts) }
      });
      this.asked.clear();
      this.waiting.clear();
      this.looks.forEach((look) => this.want(look));
    }
    /** A new picture has come; looks follow it. */
    follow(which) {
      if (which !== "replay") this.refresh((what) => !isStill(what));
    }
    /** The target has been turned. */
    turned() {
      this.refresh((what) => what.startsWith("B:"));
    }
    answer(frame) {
      this.asked.delete(frame.of);
      this.looksAt(frame.of)?.draw(frame);
      this.next();
    }
    /** There is no answer: to what was asked, or nobody knows to what. */
    fail(of) {
      if (of) {
        this.asked.delete(of);
        this.looksAt(of)?.hide();
      } else this.asked.clear();
      this.next();
    }
    /** A page that looks on cannot ask. */
    leave() {
      this.looks.forEach((look) => look.leave());
      this.waiting.clear();
      this.asked.clear();
    }
    looksAt(what) {
      return this.looks.find((look) => look.what === what);
    }
    refresh(isMeant) {
      this.looks.filter(({ what }) => what && isMeant(what)).forEach((look) => this.want(look));
    }
    want(look) {
      if (!look.what) return look.hide();
      this.waiting.add(look);
      this.next();
    }
    next() {
      for (const look of this.waiting) {
        const { what } = look;
        if (this.asked.has(what)) continue;
        if (!this.connection.ask({ do: "look", what })) return;
        this.waiting.delete(look);
        this.asked.add(what);
      }
    }
  };

  // src/notices.ts
  var LONG_ENOUGH = 2e4;
  var Notices = class {
    said = byId("said");
    problems = byId("problems");
    timer = 0;
    lasting = /* @__PURE__ */ new Map();
    /** In the status line for a while, heard by screen readers when they are done. */
    say(text) {
      this.said.textContent = text;
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.said.textContent = "", LONG_ENOUGH);
    }
    /** Stays until it is put away, or the same is said again. */
    problem(text) {
      const known = [...this.problems.children].find((shown2) => shown2.firstChild?.textContent === text);
      known?.remove();
      const away = made2("button", { type: "button", className: "plain", textContent: "Close" });
      const shown = made2("p", {}, made2("span", { textContent: text }), away);
      away.onclick = () => shown.remove();
      this.problems.append(shown);
      while (this.problems.children.length > 3) this.problems.firstChild?.remove();
    }
    /** Show something for as long as it lasts; null when it is over. */
    while(name, lasting) {
      if (lasting) this.lasting.set(name, lasting);
      else this.lasting.delete(name);
      const banner = byId("banner");
      banner.hidden = !this.lasting.size;
      banner.replaceChildren(
        ...[...this.lasting.values()].map(({ text, button }) => {
          const shown = made2("p", {}, made2("span", { textContent: text }));
          if (button) shown.append(made2("button", { type: "button", textContent: button.text, onclick: button.press }));
          return shown;
        })
      );
    }
  };

  // src/colour.ts
  function rgbOf({ hue, saturation, value }) {
    const channel = (offset) => {
      const k = (offset + hue / 60) % 6;
      return Math.round(255 * value * (1 - saturation * Math.max(0, Math.min(k, 4 - k, 1))));
    };
    return [channel(5), channel(3), channel(1)];
  }
  function colourOf([red, green, blue], before) {
    const most = Math.max(red, green, blue);
    const range = most - Math.min(red, green, blue);
    const value = most / 255;
    if (!range) return { hue: before?.hue ?? 0, saturation: 0, value };
    const sector = most === red ? (green - blue) / range : most === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
    return { hue: (60 * sector + 360) % 360, saturation: range / most, value };
  }
  var hexOf = (rgb) => "#" + rgb.map((channel) => channel.toString(16).padStart(2, "0")).join("");
  function fromHex(text) {
    const digits = /^#?([0-9a-f]{6})$/i.exec(text.trim())?.[1];
    return digits ? [0, 2, 4].map((k) => parseInt(digits.slice(k, k + 2), 16)) : null;
  }

  // src/popup.ts
  var Popup = class {
    button;
    panel;
    open;
    /** `open` shows or hides the panel. */
    constructor(button, panel, open) {
      this.button = button;
      this.panel = panel;
      this.open = open;
      button.onclick = () => this.turn(!this.isOpen);
      addEventListener("pointerdown", ({ target }) => {
        if (this.isOpen && target instanceof Node && !panel.contains(target) && !button.contains(target)) this.turn(false);
      });
      addEventListener("keydown", (event) => {
        if (event.key !== "Escape" || !this.isOpen) return;
        const hadFocus = this.panel.contains(document.activeElement);
        this.turn(false);
        if (hadFocus) this.button.focus();
      });
    }
    get isOpen() {
      return this.button.ariaExpanded === "true";
    }
    turn(isOpen) {
      this.button.ariaExpanded = String(isOpen);
      this.open(isOpen);
    }
  };

  // src/palette.ts
  var PARTS = { hue: 360, saturation: 100, value: 100 };
  var Palette = class {
    settings;
    button = byId("colour");
    number = byId("colour-number");
    colour;
    constructor(settings) {
      this.settings = settings;
      this.colour = colourOf(settings.chosen.rgb);
      const panel = byId("palette");
      new Popup(this.button, panel, (isOpen) => panel.hidden = !isOpen);
      for (const part of Object.keys(PARTS)) {
        const slider = byId(part);
        slider.oninput = () => {
          this.colour = { ...this.colour, [part]: part === "hue" ? slider.valueAsNumber % 360 : slider.valueAsNumber / 100 };
          this.choose(rgbOf(this.colour));
        };
      }
      this.number.onchange = () => {
        const rgb = fromHex(this.number.value);
        if (rgb) this.choose(rgb);
        else this.number.value = hexOf(settings.chosen.rgb);
      };
      settings.onChange(() => this.show());
    }
    choose(rgb) {
      this.settings.choose({ rgb, usesTexture: false });
    }
    show() {
      const { rgb, recent } = this.settings.chosen;
      if (rgbOf(this.colour).join() !== rgb.join()) this.colour = colourOf(rgb, this.colour);
      const { hue, saturation, value } = this.colour;
      byId("hue").value = String(Math.round(hue));
      byId("saturation").value = String(Math.round(100 * saturation));
      byId("value").value = String(Math.round(100 * value));
      this.number.value = hexOf(rgb);
      const { style } = document.documentElement;
      style.setProperty("--colour", hexOf(rgb));
      style.setProperty("--full", hexOf(rgbOf({ hue, saturation: 1, value })));
      style.setProperty("--grey", hexOf(rgbOf({ hue, saturation: 0, value })));
      style.setProperty("--bright", hexOf(rgbOf({ hue, saturation, value: 1 })));
      this.button.ariaLabel = `Colour, ${hexOf(rgb)}`;
      byId("recent").replaceChildren(
        ...recent.map((each) => {
          const label = hexOf(each);
          const swatch = made2("button", { type: "button", className: "swatch", title: label, ariaLabel: `Colour ${label}` });
          swatch.style.background = label;
          swatch.onclick = () => this.choose(each);
          return swatch;
        })
      );
    }
  };

  // src/parameters.ts
  var LONGEST2 = 64;
  var NAMES = {
    patch_width: "patch width w",
    spacing: "spacing r",
    levels: "levels L",
    mu: "style \u03BC",
    depth: "depth D",
    uniformity: "uniformity \u03BB"
  };
  var Parameters = class {
    connection;
    changed;
    unsent = {};
    askFrame;
    constructor(connection, changed2) {
      this.connection = connection;
      this.changed = changed2;
      this.askFrame = oncePerFrame(() => {
        this.connection.ask({ do: "parameters", values: this.unsent });
        this.unsent = {};
      });
      for (const of of ["live", "dense"]) byId(`of-${of}`).onchange = () => this.meant(of);
    }
    offer(fields, values) {
      for (const of of ["live", "dense"]) {
        const rows = fields.filter((field) => field.of === of).map((field) => this.row(field, values[field.name]));
        byId(`${of}-fields`).replaceChildren(...rows);
      }
      byId("of").hidden = !fields.some((field) => field.of === "dense");
      this.meant(byId("of-dense").checked ? "dense" : "live");
    }
    /** Parameters of the other kind of method move nothing, so they are greyed. */
    meant(of) {
      for (const each of ["live", "dense"]) byId(`${each}-fields`).disabled = each !== of;
    }
    row(field, value) {
      const textContent = NAMES[field.name] ?? field.name.replaceAll("_", " ");
      const name = made2("span", { textContent, title: field.help });
      const set = (now) => {
        this.unsent[field.name] = now;
        this.changed(field.name, now);
        this.askFrame();
      };
      if (field.kind === "several") return this.severalRow(field, name, value, set);
      const control = field.kind === "flag" ? flag(value, set) : field.kind === "choice" ? choice(field.choices ?? [], String(value), set) : number(field, value, set);
      return made2("label", { className: field.kind === "flag" ? "row flag" : "row" }, name, ...control);
    }
    /** A value for each level, the finest first; the last goes for all above. */
    severalRow(field, name, begun, set) {
      const values = [...begun];
      const rows = made2("div", { className: "levels" });
      const set_ = () => set([...values]);
      const button = (text, label, press) => made2("button", { type: "button", className: "small", textContent: text, ariaLabel: label, onclick: press });
      const fewer = button("\u2212", `One level fewer for ${name.textContent}`, () => change(() => values.pop()));
      const more = button("+", `One level more for ${name.textContent}`, () => change(() => values.push(values.at(-1))));
      const change = (step) => {
        step();
        draw();
        set_();
      };
      const draw = () => {
        fewer.disabled = values.length < 2;
        more.disabled = values.length > 11;
        rows.replaceChildren(
          ...values.map((value, level) => {
            const isLast = level === values.length - 1;
            const text = isLast && level ? `from ${level}` : isLast ? "all" : `level ${level}`;
            const control = number(field, value, (now) => {
              values[level] = now;
              set_();
            });
            return made2("label", { className: "row" }, made2("span", { textContent: text }), ...control);
          })
        );
      };
      draw();
      const head = made2("div", { className: "row" }, name, made2("span", { className: "push" }), fewer, more);
      return made2("div", { className: "several", role: "group", ariaLabel: name.textContent }, head, rows);
    }
  };
  function flag(value, set) {
    const box = made2("input", { type: "checkbox", checked: value });
    box.onchange = () => set(box.checked);
    return [box];
  }
  function choice(choices, value, set) {
    const select = made2("select", {}, ...choices.map((each) => new Option(each, each, false, each === value)));
    select.onchange = () => set(select.value);
    return [select];
  }
  function number({ least, most, kind, optional, odd }, value, set) {
    const range = (most ?? Infinity) - (least ?? -Infinity);
    const step = kind === "number" ? String(range / 100) : odd ? "2" : "1";
    const limits = { step, min: String(least ?? ""), max: String(most ?? "") };
    if (range > LONGEST2 && kind !== "number" || optional) {
      const box = made2("input", { type: "number", ...limits, value: value === null ? "" : String(value) });
      if (optional) box.placeholder = "auto";
      box.onchange = () => {
        if (box.value === "" ? !optional : !box.checkValidity()) box.reportValidity();
        else set(box.value === "" ? null : box.valueAsNumber);
      };
      return [box];
    }
    const shown = made2("output", { textContent: String(value) });
    const slider = made2("input", { type: "range", ...limits, value: String(value) });
    slider.oninput = () => {
      shown.textContent = String(+slider.valueAsNumber.toFixed(2));
      set(slider.valueAsNumber);
    };
    return [slider, shown];
  }

  // src/picker.ts
  var Picker = class {
    painting = null;
    settings;
    notices;
    /** The tool that it was taken up from. */
    before = "brush";
    constructor(settings, notices) {
      this.settings = settings;
      this.notices = notices;
      settings.onChange(() => {
        if (settings.chosen.tool === "brush" || settings.chosen.tool === "eraser") this.before = settings.chosen.tool;
      });
    }
    pick(x, y) {
      const pixel = this.painting?.at(x, y) ?? null;
      if (pixel === null) return;
      const rgb = [pixel & 255, pixel >> 8 & 255, pixel >> 16 & 255];
      this.settings.choose({ rgb, usesTexture: false });
    }
    /** A colour is picked: back to the brush, as whoever picks one wants to paint with it. */
    done() {
      this.notices.say(`Picked ${hexOf(this.settings.chosen.rgb)}.`);
      if (this.settings.chosen.tool === "picker") this.settings.choose({ tool: "brush" });
    }
    /** Take it up, or lay it down. */
    toggle() {
      const { tool } = this.settings.chosen;
      this.settings.choose({ tool: tool === "picker" ? this.before : "picker" });
    }
  };

  // src/progress.ts
  var Progress = class {
    busy = /* @__PURE__ */ new Map();
    /** Kernels are compiled, once for every installation. */
    compiling(text, done, total) {
      const bar = byId("compiled");
      bar.max = Math.max(total, 1);
      bar.value = done;
      byId("compiling-text").textContent = text;
      byId("compiling").hidden = done >= total;
    }
    working({ which, state, text }) {
      if (state === "started") this.busy.set(which, `${which} ${text || "is being made"}`);
      else this.busy.delete(which);
      byId("working").textContent = [...this.busy.values()].join(", ");
      byId("finish").classList.toggle("busy", this.busy.has("full"));
    }
    forget() {
      this.busy.clear();
      byId("working").textContent = "";
      byId("compiling").hidden = true;
    }
  };

  // src/result.ts
  var MEANINGS = {
    replay: "the last match, with your new paint",
    coherent: "searched anew with the same seed",
    warm: "searched on from the last step of the turn",
    fast: "the dense method, preset fast",
    full: "the full method",
    step: "by the step buttons"
  };
  var Result = class {
    which = null;
    screen = new Screen(byId("picture"));
    latency;
    newest = null;
    /** The last that is no step, to go back to. */
    live = null;
    serial = 0;
    askFrame;
    constructor(latency) {
      this.latency = latency;
      this.askFrame = atOnceAndPerFrame(() => this.draw());
      byId("back").onclick = () => {
        this.newest = this.live;
        this.askFrame();
      };
    }
    /** Begin again, as the server counts serials from elsewhere. */
    forget() {
      this.serial = 0;
      this.newest = this.live = null;
    }
    show(frame) {
      if (frame.serial < this.serial) return;
      this.serial = frame.serial;
      this.newest = frame;
      if (frame.which !== "step") this.live = frame;
      this.askFrame();
    }
    draw() {
      const { newest } = this;
      if (!newest) return;
      this.newest = null;
      const { which, width, height, serial, milliseconds } = newest;
      this.screen.show(width, height, newest.rgb);
      this.which = which;
      byId("empty").hidden = true;
      byId("back").hidden = which !== "step" || !this.live;
      byId("which").textContent = which;
      byId("which").dataset.which = which;
      byId("took").textContent = timeOf(milliseconds);
      byId("meaning").textContent = which === "look" ? "" : MEANINGS[which];
      this.latency.shows(which, serial);
    }
  };
  function timeOf(milliseconds) {
    if (milliseconds < 9.95) return `${milliseconds.toFixed(1)} ms`;
    return milliseconds < 999.5 ? `${milliseconds.toFixed(0)} ms` : `${(milliseconds / 1e3).toFixed(1)} s`;
  }

  // src/room.ts
  var WIDE = matchMedia("(min-width: 1100px)");
  function room() {
    const button = byId("panels-open");
    const shows = (name) => (isShown) => void document.body.classList.toggle(name, isShown);
    const showPanels = (areShown) => {
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
    const help = byId("help-dialog");
    byId("help").onclick = () => help.showModal();
    for (const close of document.querySelectorAll("[data-close]"))
      close.onclick = () => close.closest("dialog")?.close();
    const views = byId("views-dialog");
    const frame = byId("views");
    byId("views-open").onclick = () => {
      views.showModal();
      if (frame.src) return;
      frame.src = "/views/";
      byId("views-wait").hidden = false;
      frame.onload = () => byId("views-wait").hidden = true;
    };
    return { togglePanels: () => button.click(), showHelp: () => help.showModal() };
  }

  // src/refusals.ts
  var Refusal = class extends Error {
  };
  var page = "";
  var namePage = (name) => void (page = name);
  async function answerTo(address, request) {
    let response;
    try {
      response = await fetch(address, { ...request, headers: { ...request?.headers, "Stylit-Page": page } });
    } catch {
      throw new Refusal("The studio does not answer. Try again when the connection is back.");
    }
    if (response.ok) return response;
    const text = await response.text();
    let sentence = text;
    try {
      sentence = JSON.parse(text).text ?? text;
    } catch {
    }
    throw new Refusal(sentence || `The studio refuses this (${response.status}).`);
  }
  var sentenceOf = (error) => error instanceof Error ? error.message : String(error);

  // src/scanning.ts
  var NAMES2 = ["top left", "top right", "bottom right", "bottom left"];
  var Scanning = class {
    dialog = byId("scan-dialog");
    state = byId("scan-state");
    photo = byId("photo");
    handles;
    send = byId("scan-send");
    corners = [];
    size = [1, 1];
    constructor() {
      const file = byId("scan-file");
      byId("scan-open").onclick = () => file.click();
      file.onchange = () => {
        const [chosen] = file.files ?? [];
        file.value = "";
        if (chosen) void this.read(chosen).catch((error) => this.tell(sentenceOf(error)));
      };
      this.handles = NAMES2.map((name, k) => this.handle(name, k));
      byId("photo-frame").append(...this.handles);
      this.send.onclick = () => void this.sendCorners().catch((error) => this.tell(sentenceOf(error)));
    }
    async read(file) {
      this.show(false);
      this.tell("The photograph is being read.");
      this.dialog.showModal();
      let bitmap;
      try {
        bitmap = await createImageBitmap(file);
      } catch {
        throw new Refusal(`${file.name} is no picture that this browser can read. Use PNG or JPEG.`);
      }
      const found = await (await answerTo("/scan", { method: "POST", body: file })).json();
      this.size = [found.width, found.height];
      Object.assign(this.photo, { width: bitmap.width, height: bitmap.height });
      this.photo.getContext("2d")?.drawImage(bitmap, 0, 0);
      bitmap.close();
      const [right, bottom] = [0.9 * found.width, 0.9 * found.height];
      const [left, top] = [0.1 * found.width, 0.1 * found.height];
      this.corners = found.corners ?? [[left, top], [right, top], [right, bottom], [left, bottom]];
      this.tell(found.text);
      this.show(true);
      this.draw();
    }
    async sendCorners() {
      const headers = { "Content-Type": "application/json" };
      const body = JSON.stringify({ corners: this.corners });
      const answer = await (await answerTo("/scan/corners", { method: "POST", headers, body })).json();
      this.tell(answer.text);
    }
    /** A corner to drag, or to move by arrow keys. */
    handle(name, k) {
      const handle = document.createElement("button");
      Object.assign(handle, { type: "button", className: "corner", ariaLabel: `Corner ${name}; arrow keys move it` });
      handle.onpointerdown = (event) => handle.setPointerCapture(event.pointerId);
      handle.onpointermove = (event) => {
        if (!handle.hasPointerCapture(event.pointerId)) return;
        const { left, top, width, height } = this.photo.getBoundingClientRect();
        this.move(k, (event.clientX - left) / width * this.size[0], (event.clientY - top) / height * this.size[1]);
      };
      handle.onkeydown = (event) => {
        const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
        if (!arrow) return;
        event.preventDefault();
        const step = this.size[0] / 1e3 * (event.shiftKey ? 20 : 1);
        this.move(k, this.corners[k][0] + arrow[0] * step, this.corners[k][1] + arrow[1] * step);
      };
      return handle;
    }
    move(k, x, y) {
      const [width, height] = this.size;
      this.corners[k] = [Math.min(Math.max(x, 0), width), Math.min(Math.max(y, 0), height)];
      this.draw();
    }
    draw() {
      const [width, height] = this.size;
      this.corners.forEach(([x, y], k) => {
        this.handles[k].style.left = `${100 * x / width}%`;
        this.handles[k].style.top = `${100 * y / height}%`;
      });
      const points = this.corners.map(([x, y]) => `${100 * x / width},${100 * y / height}`);
      byId("photo-outline").firstElementChild?.setAttribute("points", points.join(" "));
    }
    show(isRead) {
      byId("photo-frame").hidden = !isRead;
      this.send.hidden = !isRead;
    }
    tell(text) {
      this.state.textContent = text;
    }
  };

  // src/sender.ts
  var REST = 80;
  var MOST_BACKLOG = 8 * 1024 * 1024;
  var Sender = class {
    /** Of the last message. */
    serial = 0;
    painting = null;
    connection;
    latency;
    unsent = null;
    /** Of the first event that made it. */
    since = 0;
    isAllowed = false;
    isResting = false;
    rested = 0;
    timer = 0;
    ask;
    constructor(connection, latency) {
      this.connection = connection;
      this.latency = latency;
      this.ask = atOnceAndPerFrame(() => this.flush());
      document.addEventListener("visibilitychange", () => document.hidden && this.flush());
    }
    /** Whether there is paint that the server does not have. */
    get isBehind() {
      return this.unsent !== null;
    }
    /** Whether what changes may be sent. */
    allow(isAllowed) {
      this.isAllowed = isAllowed;
      this.ask();
    }
    changed(rect, time = performance.now()) {
      if (!rect) return;
      if (!this.unsent) this.since = time;
      this.unsent = around(this.unsent, rect);
      this.isResting = false;
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.rest(), REST);
      this.ask();
    }
    /** The brush rests, or its stroke is done. */
    rest() {
      clearTimeout(this.timer);
      this.isResting = true;
      this.ask();
    }
    /** The server has other strokes than the page, or fewer: it gets the whole painting. */
    sendAll() {
      if (!this.painting) return;
      this.changed(this.painting.whole);
      this.rest();
    }
    /** Nothing is left to be sent: the painting is the server's. */
    forget(serial) {
      this.serial = this.rested = serial;
      this.unsent = null;
      this.isResting = false;
      clearTimeout(this.timer);
    }
    /** Show and send what has changed so far. */
    flush() {
      this.painting?.show();
      if (!this.isAllowed || !this.painting) return;
      if (this.unsent) {
        if (this.connection.backlog > MOST_BACKLOG) return this.ask();
        this.serial = this.serial + 1 >>> 0;
        this.connection.send(rectMessage(this.unsent, this.serial, this.painting.read(this.unsent)));
        this.latency.sends(this.serial, this.since);
        this.unsent = null;
      }
      if (this.isResting && this.rested !== this.serial) {
        this.rested = this.serial;
        this.latency.rests(this.serial);
        this.connection.ask({ do: "rest", serial: this.serial });
      }
    }
  };

  // src/session.ts
  var LIVE = ["replay", "coherent", "warm"];
  var Session = class {
    painting = null;
    role = null;
    parts;
    scenes = [];
    scene = "";
    /** The folder of the painting. */
    folder = "";
    /** Which painting comes next, after a welcome. */
    awaited = null;
    wasLost = false;
    /** Whether a scene is. */
    isOpening = false;
    constructor(parts) {
      this.parts = parts;
      const { connection } = parts;
      const chosen = byId("scene");
      chosen.onchange = () => this.open(chosen.value);
      const seed = byId("seed");
      seed.onchange = () => seed.checkValidity() ? connection.ask({ do: "seed", value: seed.valueAsNumber }) : seed.reportValidity();
      byId("seed-next").onclick = () => {
        const before = seed.checkValidity() ? seed.valueAsNumber : -1;
        seed.value = String((before + 1) % 2 ** 32);
        connection.ask({ do: "seed", value: seed.valueAsNumber });
      };
    }
    said(said) {
      const { notices, progress, steps, exporting } = this.parts;
      switch (said.say) {
        case "welcome":
          return this.welcome(said);
        case "scene":
          return this.choose(said);
        case "role":
          return this.take(said.role);
        case "working":
          progress.working(said);
          return said.state === "failed" ? notices.problem(said.text) : void 0;
        case "compiling":
          return progress.compiling(said.text, said.done, said.total);
        case "problem":
          this.parts.looks.fail(said.of);
          exporting.fail(said.text);
          return notices.problem(said.text);
        case "saved":
          return void (byId("saved").textContent = said.text);
        case "stepped":
          return steps.tell(said);
        case "exported":
          return exporting.tell(said);
        case "notes":
          return said.texts.length ? notices.say(said.texts.join(" ")) : void 0;
      }
    }
    frame(frame) {
      const { result, looks, steps } = this.parts;
      if (frame.isPainting) return this.repaint(frame);
      if (frame.which === "look") return looks.answer(frame);
      if (LIVE.includes(frame.which)) steps.leave();
      result.show(frame);
      looks.follow(frame.which);
    }
    lost() {
      const { notices, sender, progress } = this.parts;
      sender.allow(false);
      this.letAsk(false);
      this.isOpening = false;
      this.awaited = null;
      this.letPaint();
      progress.forget();
      const isAgain = this.wasLost;
      this.wasLost = true;
      if (!this.painting) return notices.while("line", { text: "The studio does not answer. The page tries again." });
      const text = "The connection is lost. Go on painting: the page tries again, and sends what you paint meanwhile.";
      notices.while("line", { text });
      if (isAgain) void fetch("/", { method: "HEAD" }).then(({ status }) => status === 403 && this.tellStranger(), () => void 0);
    }
    /** Somebody has chosen a parameter on the page. */
    changed(name, value) {
      if (name !== "levels") return;
      this.parts.looks.offer(this.now, value);
    }
    tellStranger() {
      const text = "The studio was started anew. Open the address that it printed; then take over here, and nothing that you painted is lost.";
      if (!this.parts.connection.isOpen) this.parts.notices.while("line", { text });
    }
    welcome(welcome) {
      const { notices, sender, result, texture } = this.parts;
      const isFirst = this.role === null;
      if (welcome.version !== VERSION) return notices.while("line", { text: "The studio is of another version than this page. Reload the page." });
      notices.while("line", null);
      namePage(welcome.page);
      if (this.folder !== welcome.painting.name) this.painting = null;
      this.folder = welcome.painting.name;
      const own = this.painting;
      const isOther = !own || own.width !== welcome.painting.width || own.height !== welcome.painting.height;
      const isAhead = !isOther && (sender.isBehind || this.role === "painter" && sender.serial > welcome.painting.serial);
      this.awaited = { serial: welcome.painting.serial, keepsOwn: isAhead };
      if (isAhead) sender.serial = Math.max(sender.serial, welcome.painting.serial);
      result.forget();
      this.scenes = welcome.scenes;
      const chosen = byId("scene");
      chosen.replaceChildren(...this.scenes.map(({ name: name2, title }) => new Option(title, name2)));
      const name = welcome.painting.name.split(/[\\/]/).at(-1);
      Object.assign(byId("name"), { textContent: name, title: welcome.painting.name });
      document.title = `${name} \xB7 Studio`;
      if (welcome.seed !== void 0) byId("seed").value = String(welcome.seed);
      this.choose(welcome);
      this.take(welcome.role);
      byId("paper-panel").hidden = !welcome.panels.includes("scan");
      byId("views-panel").hidden = !welcome.panels.includes("views");
      if (welcome.panels.includes("texture") && byId("texture-panel").hidden)
        texture.open().catch((error) => notices.problem(sentenceOf(error)));
      if (welcome.notes.length && (isFirst || this.wasLost)) notices.say(welcome.notes.join(" "));
      else if (this.wasLost) notices.say(isAhead ? "Connected again; what you painted meanwhile is sent." : "Connected again.");
      this.wasLost = false;
    }
    /** Another scene. It may have a painting of its own, so the brush waits until it is there. */
    open(name) {
      const { artist, sender, connection, notices } = this.parts;
      artist.end();
      sender.flush();
      if (!connection.ask({ do: "scene", name })) return;
      this.isOpening = true;
      this.letPaint();
      notices.say("The scene is being opened; the brush waits for it.");
    }
    choose({ scene, step, parameters, weights, layers }) {
      const { turning, looks, guides, steps } = this.parts;
      this.isOpening = false;
      this.letPaint();
      this.scene = byId("scene").value = scene;
      this.parts.parameters.offer(parameters.fields, parameters.values);
      this.parts.shows(this.now);
      turning.offer(this.now.steps, step);
      guides.offer(this.now, weights, layers ?? []);
      steps.leave();
      looks.offer(this.now, Number(parameters.values.levels ?? 0));
    }
    get now() {
      return this.scenes.find(({ name }) => name === this.scene);
    }
    take(role) {
      const { notices, connection, sender, looks } = this.parts;
      const isReader = role === "reader";
      if (isReader) looks.leave();
      this.role = role;
      this.letPaint();
      sender.allow(false);
      document.body.classList.toggle("reads", isReader);
      allow("fieldset.brushes", !isReader);
      this.letAsk(!isReader);
      const text = sender.isBehind ? "Another page has the brush. This one holds strokes that the studio does not have: take over to keep them." : "Another page has the brush; this one looks on.";
      const button = { text: "Take over", press: () => void connection.ask({ do: "take_over" }) };
      notices.while("role", isReader ? { text, button } : null);
    }
    /** Whether what only a painter may ask can be asked: nothing while the studio does not answer. */
    letAsk(may) {
      allow("fieldset.painters", may);
    }
    /** A painter may paint, but for the time until another painting is there. */
    letPaint() {
      const { artist } = this.parts;
      artist.mayPaint = this.role === "painter" && !this.isOpening && !this.awaited;
      artist.tell();
    }
    repaint(frame) {
      const { artist, sender } = this.parts;
      const { awaited } = this;
      const isBeginning = frame.serial === 0;
      const isOther = this.painting?.width !== frame.width || this.painting.height !== frame.height;
      if (isOther) this.begin(frame);
      if (isBeginning) artist.beginning = inkOf(frame);
      if (awaited) {
        if (frame.serial !== awaited.serial) return;
        this.awaited = null;
        if (awaited.keepsOwn) {
          if (this.role === "painter") sender.sendAll();
        } else this.adopt(frame);
      } else if (isOther) this.adopt(frame);
      else if (this.role === "painter" && !isBeginning) {
        artist.replace(frame.rgb);
        if (frame.serial < sender.serial) sender.sendAll();
        else sender.forget(frame.serial);
      } else if (!isBeginning && !sender.isBehind) this.adopt(frame);
      this.letPaint();
      sender.allow(this.role === "painter");
    }
    begin(frame) {
      const { artist, uses, sender } = this.parts;
      this.painting = new Painting(byId("painting"), frame.width, frame.height);
      artist.use(this.painting);
      sender.forget(frame.serial);
      uses(this.painting);
      byId("no-painting").hidden = true;
    }
    adopt(frame) {
      const { artist, sender } = this.parts;
      this.painting?.replace(frame.rgb);
      if (frame.serial !== sender.serial) artist.forget();
      sender.forget(frame.serial);
    }
  };
  function allow(fieldsets, may) {
    for (const set of document.querySelectorAll(fieldsets)) set.disabled = !may;
  }
  function inkOf({ width, height, rgb }) {
    const pixels = new Uint32Array(width * height);
    fromRgb(rgb, pixels);
    return { width, height, pixels };
  }

  // src/settings.ts
  var LARGEST = 400;
  var KEY = "stylit-studio-tool";
  var MOST_RECENT = 10;
  var DEFAULTS = {
    tool: "brush",
    brush: { size: 14, opacity: 1, hardness: 0.7, smoothing: 0.15, grain: "smooth", pressure: "size", tilts: true },
    rgb: [34, 51, 91],
    usesTexture: false,
    erasesTo: "beginning",
    recent: [[34, 51, 91], [178, 58, 42], [232, 163, 61], [74, 124, 89], [92, 158, 178], [246, 240, 226]]
  };
  var Settings = class {
    chosen = remembered();
    told = [];
    /** Call it now and whenever something is chosen. */
    onChange(tell) {
      this.told.push(tell);
      tell();
    }
    choose(change) {
      this.chosen = { ...this.chosen, ...change };
      this.told.forEach((tell) => tell());
      localStorage.setItem(KEY, JSON.stringify(this.chosen));
    }
    shape(change) {
      this.choose({ brush: { ...this.chosen.brush, ...change } });
    }
    /** A colour has been painted with. */
    used(rgb) {
      const isOther = (known) => known.join() !== rgb.join();
      if (isOther(this.chosen.recent[0])) this.choose({ recent: [rgb, ...this.chosen.recent.filter(isOther)].slice(0, MOST_RECENT) });
    }
  };
  function remembered() {
    try {
      const kept = JSON.parse(localStorage.getItem(KEY) ?? "{}");
      const tool = kept.tool === "eraser" ? "eraser" : "brush";
      return { ...DEFAULTS, ...kept, tool, usesTexture: false, brush: { ...DEFAULTS.brush, ...kept.brush } };
    } catch {
      return DEFAULTS;
    }
  }

  // src/shortcuts.ts
  var KEY2 = "stylit-studio-letters";
  function shortcuts(actions, undo, redo) {
    const letters = byId("letters");
    letters.checked = localStorage.getItem(KEY2) !== "off";
    letters.onchange = () => localStorage.setItem(KEY2, letters.checked ? "on" : "off");
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

  // src/steps.ts
  var OPERATIONS = {
    restart: ["Begin", "Begin again at the coarsest level"],
    pyramid: ["Pyramid", "Make the levels of A, A\u2032 and B"],
    upsample: ["Upsample", "Bring the matches to the next finer level"],
    half: ["Half iteration", "Search for every second entry of the grid"],
    blend: ["Blend", "Average the patches into B\u2032"],
    iteration: ["Iteration", "Both halves, and a blend"],
    level: ["Level", "All that is left of this level"]
  };
  var Steps = class {
    buttons;
    constructor(connection) {
      this.buttons = new Map(
        Object.entries(OPERATIONS).map(([operation, [textContent, title]]) => [
          operation,
          made2("button", { type: "button", textContent, title, onclick: () => connection.ask({ do: "step", operation }) })
        ])
      );
      byId("operations").replaceChildren(...this.buttons.values());
      this.leave();
    }
    /** Nothing is begun: the live picture has gone on. */
    leave() {
      this.allow(["restart"]);
      byId("stepped").textContent = "Go through the method step by step. Painting goes on live.";
    }
    tell({ level, iteration, done, possible }) {
      this.allow(possible);
      byId("stepped").textContent = done ? "The picture is done." : `Level ${level}, iteration ${iteration}.`;
    }
    allow(possible) {
      for (const [operation, button] of this.buttons) button.disabled = !possible.includes(operation);
    }
  };

  // src/spot.ts
  var ARROWS2 = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, -1],
    ArrowDown: [0, 1]
  };
  var Spot = class {
    canvas;
    x = 0;
    y = 0;
    ring;
    /** `moved` is called when it is led elsewhere, `pressed` by Enter or Space. */
    constructor(canvas, ring, moved, pressed) {
      this.canvas = canvas;
      this.ring = ring;
      canvas.addEventListener("keydown", (event) => {
        const arrow = ARROWS2[event.key];
        if (arrow) {
          const step = event.shiftKey ? 8 : 1;
          this.put(this.x + arrow[0] * step, this.y + arrow[1] * step);
          moved();
        } else if (event.key === "Enter" || event.key === " ") pressed();
        else return;
        event.preventDefault();
        event.stopPropagation();
      });
    }
    /** Whether a place of the window lies on it; if so, the spot goes there. */
    pointAt(event) {
      const { left, top, width, height } = this.canvas.getBoundingClientRect();
      const [x, y] = [(event.clientX - left) / width, (event.clientY - top) / height];
      if (x < 0 || y < 0 || x >= 1 || y >= 1) return false;
      this.put(Math.floor(x * this.canvas.width), Math.floor(y * this.canvas.height));
      return true;
    }
    put(x, y) {
      const { width, height } = this.canvas;
      this.x = Math.min(Math.max(x, 0), width - 1);
      this.y = Math.min(Math.max(y, 0), height - 1);
      this.ring.style.left = `${100 * (this.x + 0.5) / width}%`;
      this.ring.style.top = `${100 * (this.y + 0.5) / height}%`;
    }
    async show(answer) {
      const bitmap = await createImageBitmap(await answer.blob());
      const isNew = this.canvas.width !== bitmap.width || this.canvas.height !== bitmap.height;
      if (isNew) Object.assign(this.canvas, { width: bitmap.width, height: bitmap.height });
      this.canvas.getContext("2d", { alpha: false, willReadFrequently: true })?.drawImage(bitmap, 0, 0);
      if (isNew) this.put(Math.floor(bitmap.width / 2), Math.floor(bitmap.height / 2));
      bitmap.close();
    }
  };

  // src/texture.ts
  var Texture = class {
    artist;
    notices;
    exemplar;
    texture;
    /** Whether the patch is still held in what is asked next; null if nothing is. */
    next = null;
    isAsking = false;
    constructor(artist, settings, notices) {
      this.artist = artist;
      this.notices = notices;
      this.exemplar = new Spot(byId("exemplar"), byId("exemplar-spot"), () => void 0, () => this.texture.canvas.focus());
      this.texture = new Spot(byId("texture"), byId("texture-spot"), () => this.ask("held"), () => this.ask("dropped"));
      const { canvas } = this.exemplar;
      let isOver = false;
      canvas.onpointerdown = (event) => {
        canvas.setPointerCapture(event.pointerId);
        this.exemplar.pointAt(event);
        isOver = false;
      };
      canvas.onpointermove = (event) => {
        if (!canvas.hasPointerCapture(event.pointerId)) return;
        const wasOver = isOver;
        isOver = this.texture.pointAt(event);
        if (isOver) this.ask("held");
        else if (wasOver) void this.reload();
      };
      canvas.onpointerup = () => isOver && this.ask("dropped");
      const paints = byId("paints-texture");
      paints.onchange = () => settings.choose({ usesTexture: paints.checked, tool: "brush" });
      settings.onChange(() => paints.checked = settings.chosen.usesTexture);
    }
    async open() {
      byId("texture-panel").hidden = false;
      await this.exemplar.show(await answerTo("/texture/exemplar"));
      await this.reload();
    }
    ask(how) {
      this.next = how;
      if (!this.isAsking) void this.drag();
    }
    async drag() {
      this.isAsking = true;
      try {
        while (this.next) {
          const keep = this.next === "dropped";
          this.next = null;
          const { exemplar, texture } = this;
          const body = JSON.stringify({ from: [exemplar.x, exemplar.y], to: [texture.x, texture.y], keep });
          const headers = { "Content-Type": "application/json" };
          await this.texture.show(await answerTo("/texture/drop", { method: "POST", headers, body }));
          if (keep) this.take();
        }
      } catch (error) {
        this.notices.problem(sentenceOf(error));
      } finally {
        this.isAsking = false;
      }
    }
    async reload() {
      try {
        await this.texture.show(await answerTo("/texture/picture"));
        this.take();
      } catch (error) {
        this.notices.problem(sentenceOf(error));
      }
    }
    /** The brush paints with what the texture is now. */
    take() {
      const { canvas } = this.texture;
      const { width, height } = canvas;
      const image = canvas.getContext("2d", { alpha: false, willReadFrequently: true })?.getImageData(0, 0, width, height);
      if (!image) return;
      this.artist.texture = { width, height, pixels: new Uint32Array(image.data.buffer) };
      byId("texture-caption").textContent = "Texture";
      byId("paints-texture").disabled = false;
    }
  };

  // src/tip.ts
  var Tip = class {
    ring;
    viewport;
    settings;
    constructor(ring, viewport, settings) {
      this.ring = ring;
      this.viewport = viewport;
      this.settings = settings;
      settings.onChange(() => {
        viewport.pane.dataset.tool = settings.chosen.tool;
        this.resize();
      });
    }
    /** Over a mouse or a pen; a finger hides it anyway. */
    follow(event) {
      const { left, top } = this.viewport.pane.getBoundingClientRect();
      if (event.pointerType === "touch") this.hide();
      else this.show(event.clientX - left, event.clientY - top, false);
    }
    /** At a place of the painting, led by keys. */
    showAt(x, y) {
      const [left, top] = this.viewport.paneAt(x, y);
      this.show(left, top, true);
    }
    hide() {
      this.ring.hidden = true;
    }
    show(left, top, byKeys) {
      this.resize();
      this.ring.hidden = false;
      this.ring.classList.toggle("keys", byKeys);
      this.ring.style.left = `${left}px`;
      this.ring.style.top = `${top}px`;
    }
    resize() {
      const size = Math.max(this.settings.chosen.brush.size * this.viewport.scale, 3);
      this.ring.style.width = this.ring.style.height = `${size}px`;
    }
  };

  // src/toolbox.ts
  var PERCENT = ["opacity", "hardness", "smoothing"];
  var SIZE_STEPS = 200;
  var GROWTH = 1.15;
  function toolbox(settings) {
    const tools = [...document.querySelectorAll("[data-tool]")].filter((each) => each.matches("button"));
    for (const button of tools) button.onclick = () => settings.choose({ tool: button.dataset.tool });
    const size = byId("size");
    size.max = String(SIZE_STEPS);
    size.oninput = () => settings.shape({ size: rounded(LARGEST ** (size.valueAsNumber / SIZE_STEPS)) });
    for (const name of PERCENT) {
      const slider = byId(name);
      slider.oninput = () => settings.shape({ [name]: slider.valueAsNumber / 100 });
    }
    const grain = byId("grain");
    for (const [name, text] of Object.entries(GRAINS)) grain.add(new Option(text, name));
    grain.onchange = () => settings.shape({ grain: grain.value });
    const pressure = byId("pressure");
    pressure.onchange = () => settings.shape({ pressure: pressure.value });
    const tilts = byId("tilts");
    tilts.onchange = () => settings.shape({ tilts: tilts.checked });
    const ground = byId("erases-to");
    ground.onchange = () => settings.choose({ erasesTo: ground.value });
    settings.onChange(() => {
      const { tool, brush, erasesTo } = settings.chosen;
      for (const button of tools) button.setAttribute("aria-pressed", String(button.dataset.tool === tool));
      size.value = String(SIZE_STEPS * Math.log(brush.size) / Math.log(LARGEST));
      size.ariaValueText = `${brush.size} pixels`;
      byId("size-shown").textContent = String(brush.size);
      for (const name of PERCENT) {
        byId(name).value = String(Math.round(100 * brush[name]));
        byId(`${name}-shown`).textContent = `${Math.round(100 * brush[name])}%`;
      }
      grain.value = brush.grain;
      pressure.value = brush.pressure;
      tilts.checked = brush.tilts;
      ground.value = erasesTo;
      byId("erases").hidden = tool !== "eraser";
    });
  }
  function resized(size, by) {
    const next = rounded(by > 0 ? size * GROWTH : size / GROWTH);
    return Math.min(Math.max(next === size ? size + by : next, 1), LARGEST);
  }
  var rounded = (size) => size < 10 ? Math.round(2 * size) / 2 : Math.round(size);

  // src/turning.ts
  var STRIDE = 14;
  var Turning = class {
    connection;
    told;
    slider = byId("turn");
    follows = byId("turn-follows");
    askFrame;
    steps = 1;
    step = 0;
    isForced = false;
    constructor(connection, pane, told) {
      this.connection = connection;
      this.told = told;
      this.askFrame = oncePerFrame(() => this.send());
      this.slider.oninput = () => this.go(this.slider.valueAsNumber);
      byId("turn-now").onclick = () => {
        this.isForced = true;
        this.askFrame();
      };
      pane.addEventListener("keydown", (event) => {
        const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
        if (!by || !this.canTurn || event.ctrlKey || event.metaKey || event.altKey) return;
        this.go(this.step + by);
        event.preventDefault();
      });
    }
    get canTurn() {
      return this.steps > 1;
    }
    offer(steps, step) {
      this.steps = steps;
      this.step = step;
      byId("turn-panel").hidden = !this.canTurn;
      this.slider.max = String(steps - 1);
      this.tell();
    }
    /** Dragging the picture sideways. */
    get drag() {
      let [from, begun] = [0, 0];
      return {
        begin: (event) => {
          [from, begun] = [event.clientX, this.step];
          return this.canTurn;
        },
        move: (event) => this.go(begun + Math.round((event.clientX - from) / STRIDE)),
        end: () => void 0,
        cancel: () => this.go(begun)
      };
    }
    /** The last step follows the first. */
    go(step) {
      const around2 = (step % this.steps + this.steps) % this.steps;
      if (around2 === this.step) return;
      this.step = around2;
      this.tell();
      this.askFrame();
    }
    tell() {
      this.slider.value = String(this.step);
      byId("turn-step").textContent = `${this.step + 1} of ${this.steps}`;
    }
    send() {
      this.connection.ask({ do: "turn", step: this.step, restylize: this.follows.checked || this.isForced });
      this.isForced = false;
      this.told();
    }
  };

  // src/viewport.ts
  var LARGEST2 = 32;
  var SMALLEST = 0.05;
  var MARGIN = 14;
  var SQUARES = 3;
  var Viewport = class {
    pane;
    scale = 1;
    sheet;
    told;
    left = 0;
    top = 0;
    width = 1;
    height = 1;
    isFitted = true;
    isSized = false;
    constructor(pane, sheet, told) {
      this.pane = pane;
      this.sheet = sheet;
      this.told = told;
      new ResizeObserver(() => this.isFitted ? this.fit() : this.keepInside()).observe(pane);
      pane.addEventListener("wheel", (event) => {
        event.preventDefault();
        const pixels = event.deltaY * (event.deltaMode ? 16 : 1);
        this.zoom(Math.exp(-pixels * (event.ctrlKey ? 0.01 : 15e-4)), event.clientX, event.clientY);
      }, { passive: false });
    }
    /** The sheet has so many pixels. */
    resize(width, height) {
      if (this.isSized && width === this.width && height === this.height) return;
      this.isSized = true;
      [this.width, this.height] = [width, height];
      this.fit();
    }
    fit() {
      const { clientWidth, clientHeight } = this.pane;
      const fitting = Math.min((clientWidth - 2 * MARGIN) / this.width, (clientHeight - 2 * MARGIN) / this.height);
      const isWhole = fitting < 1 && this.width <= clientWidth && this.height <= clientHeight;
      this.scale = isWhole ? 1 : Math.max(fitting, SMALLEST);
      this.left = Math.round((clientWidth - this.scale * this.width) / 2);
      this.top = Math.round((clientHeight - this.scale * this.height) / 2);
      this.isFitted = true;
      this.lay();
    }
    /** Larger by a factor, around a place of the window; else around the middle. */
    zoom(factor, clientX, clientY) {
      const { left, top, width, height } = this.pane.getBoundingClientRect();
      const [x, y] = [(clientX ?? left + width / 2) - left, (clientY ?? top + height / 2) - top];
      const scale = Math.min(Math.max(this.scale * factor, SMALLEST), LARGEST2);
      this.left = x - (x - this.left) * scale / this.scale;
      this.top = y - (y - this.top) * scale / this.scale;
      this.scale = scale;
      this.keepInside();
    }
    pan(right, down) {
      this.left += right;
      this.top += down;
      this.keepInside();
    }
    /** The place of the sheet under a place of the window, in pixels of the sheet. */
    placeAt(clientX, clientY) {
      const { left, top } = this.pane.getBoundingClientRect();
      return [(clientX - left - this.left) / this.scale, (clientY - top - this.top) / this.scale];
    }
    /** The place of the pane over a place of the sheet. */
    paneAt(x, y) {
      return [this.left + x * this.scale, this.top + y * this.scale];
    }
    /** Some of the sheet can always be seen. */
    keepInside() {
      const kept = (start2, length, room2) => {
        const least = Math.min(48, length, room2);
        return Math.min(Math.max(start2, least - length), room2 - least);
      };
      this.left = kept(this.left, this.scale * this.width, this.pane.clientWidth);
      this.top = kept(this.top, this.scale * this.height, this.pane.clientHeight);
      this.isFitted = false;
      this.lay();
    }
    lay() {
      const { style } = this.sheet;
      style.width = `${this.width}px`;
      style.height = `${this.height}px`;
      style.setProperty("--scale", String(this.scale));
      style.transform = `translate(${this.left}px, ${this.top}px) scale(${this.scale})`;
      this.sheet.classList.toggle("squares", this.scale >= SQUARES);
      if (this.isSized) this.told(this.scale);
    }
  };

  // src/main.ts
  function start() {
    const notices = new Notices();
    const settings = new Settings();
    const latency = new Latency();
    const connection = new Connection();
    const sender = new Sender(connection, latency);
    const artist = new Artist(settings, sender, () => {
      byId("undo").disabled = !artist.mayPaint || !artist.history.canUndo;
      byId("redo").disabled = !artist.mayPaint || !artist.history.canRedo;
    });
    const zoomed = (id) => (scale) => byId(id).textContent = `${Math.round(100 * scale)}%`;
    const left = new Viewport(byId("easel"), byId("painting-sheet"), zoomed("painting-zoom"));
    const right = new Viewport(byId("target"), byId("picture-sheet"), zoomed("picture-zoom"));
    const picker = new Picker(settings, notices);
    const tip = new Tip(byId("tip"), left, settings);
    const keys = new KeyboardHand(left.pane, artist, picker, settings, tip, notices);
    const result = new Result(latency);
    const looks = new Looks(connection);
    const turning = new Turning(connection, right.pane, () => looks.turned());
    new Hands(left, easel(left, artist, picker, settings, tip));
    new Hands(right, turning.drag);
    const session = new Session({
      connection,
      sender,
      artist,
      result,
      looks,
      turning,
      notices,
      guides: new Guides(connection),
      steps: new Steps(connection),
      exporting: new Exporting(connection, byId("export")),
      progress: new Progress(),
      texture: new Texture(artist, settings, notices),
      parameters: new Parameters(connection, (name, value) => session.changed(name, value)),
      uses: (painting) => {
        picker.painting = keys.painting = painting;
        left.resize(painting.width, painting.height);
      },
      shows: ({ width, height }) => right.resize(width, height)
    });
    const finish = () => connection.ask({ do: "finish" });
    const fit = () => [left, right].forEach((viewport) => viewport.fit());
    const zoom = (factor) => () => [left, right].forEach((viewport) => viewport.zoom(factor));
    const undo = () => artist.undo();
    const redo = () => artist.redo();
    byId("finish").onclick = finish;
    byId("undo").onclick = undo;
    byId("redo").onclick = redo;
    byId("fit").onclick = fit;
    toolbox(settings);
    new Palette(settings);
    new Scanning();
    const { togglePanels, showHelp } = room();
    const take = (tool) => () => settings.choose({ tool });
    const resize = (by) => () => settings.shape({ size: resized(settings.chosen.brush.size, by) });
    const opacities = Array.from({ length: 10 }, (_, k) => [`${(k + 1) % 10}`, () => settings.shape({ opacity: (k + 1) / 10 })]);
    shortcuts({
      b: take("brush"),
      e: take("eraser"),
      h: take("hand"),
      i: () => picker.toggle(),
      "[": resize(-1),
      "]": resize(1),
      z: undo,
      Z: redo,
      f: fit,
      F: finish,
      "+": zoom(1.25),
      "=": zoom(1.25),
      "-": zoom(0.8),
      p: togglePanels,
      "?": showHelp,
      ...Object.fromEntries(opacities)
    }, undo, redo);
    addEventListener("beforeunload", (event) => sender.isBehind && !connection.isOpen && event.preventDefault());
    window.stylitStudio = { session, artist, sender, latency, result };
    connection.begin(session);
  }
  document.addEventListener("DOMContentLoaded", start);
})();
