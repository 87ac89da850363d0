// How fast frames come, and whether limited search has to wait until the drawing rests.

/** Less than 20 frames a second. */
const SLOW = 50;
const REMEMBERED = 8;
const ENOUGH = 3;

export class Pace {
  private intervals: number[] = [];
  private last: number | null = null;
  /** Milliseconds of a frame with all passes; 0 as long as none was drawn. */
  private whole = 0;

  /** A frame was drawn in motion, with all passes or without. */
  moved(now: number, isWhole: boolean): void {
    this.intervals = this.last === null ? [] : [...this.intervals, now - this.last].slice(-REMEMBERED);
    this.last = now;
    if (isWhole && this.intervals.length >= ENOUGH) this.whole = this.interval;
  }

  /** The motion has ended; a frame with all passes may have been drawn since. */
  rested(wholeFrame: number | null): void {
    this.last = null;
    if (wholeFrame !== null) this.whole = wholeFrame;
  }

  /** Whether a frame with all passes takes too long in motion, or may. */
  get isSlow(): boolean {
    return this.whole === 0 || this.whole > SLOW;
  }

  /** Of the last motion; before that as the one frame at rest tells. */
  get framesPerSecond(): number | null {
    const time = this.intervals.length ? this.interval : this.whole;
    return time > 0 ? 1000 / time : null;
  }

  private get interval(): number {
    return this.intervals.reduce((sum, each) => sum + each, 0) / this.intervals.length;
  }
}
