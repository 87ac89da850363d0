// How fast frames come, and whether limited search has to wait until the drawing rests.

/** Less than 20 frames a second. */
const SLOW = 50;
const REMEMBERED = 8;
const ENOUGH = 3;
/** A frame that is asked for later than this after the one before waited for the hand. */
const PROMPT = 20;

export class Pace {
  private intervals: number[] = [];
  private last: number | null = null;
  /** When the last frame was handed to the browser. */
  private drawn = 0;
  /** Milliseconds of a frame with all passes; 0 as long as none was drawn. */
  private whole = 0;

  /** A frame was drawn in motion, with all passes or without: when it was asked for, begun and drawn. */
  moved(asked: number, begun: number, drawn: number, isWhole: boolean): void {
    const isPrompt = this.last !== null && asked - this.drawn < PROMPT;
    this.intervals = isPrompt ? [...this.intervals, begun - (this.last as number)].slice(-REMEMBERED) : [];
    [this.last, this.drawn] = [begun, drawn];
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
