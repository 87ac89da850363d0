// From places of a pen to evenly spaced marks: the brush hangs on the pen by a string, which takes tremor
// away, and its way is curved.

import { dabOf, spacingOf, type Brush, type Dab } from "./brush.js";
import type { Sample } from "./pen.js";

/** Of a brush that is smoothed most, the string in diameters; and in pixels besides. */
const STRING = 1;
const STRING_PIXELS = 24;
/** Pixels from point to point of a curve. */
const CHORD = 1;

export class Path {
  private readonly brush: Brush;
  private readonly string: number;
  /** Where the brush is. */
  private held: Sample;
  private pen: Sample;
  /** Where the curve has come to, and the last mark. */
  private end: Sample;
  private direction = 0;
  private sinceDab = Infinity;
  private spacing = 0;

  constructor(brush: Brush, start: Sample) {
    this.brush = brush;
    this.string = brush.smoothing * (STRING * brush.size + STRING_PIXELS);
    this.held = this.pen = this.end = start;
  }

  /** The mark where it begins. */
  *begin(): Generator<Dab> {
    // Hairs cannot be laid out before the brush goes somewhere.
    if (this.brush.grain !== "bristles") yield* this.mark(this.end);
  }

  *move(pen: Sample): Generator<Dab> {
    this.pen = pen;
    const [x, y] = [pen.x - this.held.x, pen.y - this.held.y];
    const distance = Math.hypot(x, y);
    if (distance <= this.string || distance === 0) return;
    const pulled = (distance - this.string) / distance;
    const next = { ...pen, x: this.held.x + pulled * x, y: this.held.y + pulled * y };
    yield* this.curve(this.held, mixed(this.held, next, 0.5));
    this.held = next;
  }

  *finish(): Generator<Dab> {
    yield* this.curve(this.held, this.pen);
    if (this.sinceDab === Infinity) yield* this.mark(this.end);
  }

  /** A quadratic curve from where it has come to. */
  private *curve(control: Sample, to: Sample): Generator<Dab> {
    const from = this.end;
    const length = Math.hypot(control.x - from.x, control.y - from.y) + Math.hypot(to.x - control.x, to.y - control.y);
    const chords = Math.ceil(length / CHORD);
    for (let k = 1; k <= chords; k++) {
      const t = k / chords;
      yield* this.line(mixed(mixed(from, control, t), mixed(control, to, t), t));
    }
  }

  private *line(to: Sample): Generator<Dab> {
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

  private *mark(sample: Sample): Generator<Dab> {
    const dab = dabOf(this.brush, sample, this.direction);
    this.spacing = spacingOf(dab);
    this.sinceDab = 0;
    yield dab;
  }
}

function mixed(one: Sample, other: Sample, part: number): Sample {
  const mix = (a: number, b: number) => a + (b - a) * part;
  return {
    x: mix(one.x, other.x),
    y: mix(one.y, other.y),
    pressure: mix(one.pressure, other.pressure),
    lean: mix(one.lean, other.lean),
    azimuth: other.azimuth,
  };
}
