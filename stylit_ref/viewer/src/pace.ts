// How fast frames come, and whether limited search has to wait until the drawing rests.

/** Less than 20 frames a second. */
const SLOW = 50;
const REMEMBERED = 8;

export class Pace {
  private intervals: number[] = [];
  private last: number | null = null;
  private whole = 0;

  /** A frame was drawn in motion. */
  moved(now: number): void {
    if (this.last !== null) this.intervals = [...this.intervals, now - this.last].slice(-REMEMBERED);
    this.last = now;
  }

  /** The motion has ended, and a frame with all passes took so long. */
  rested(milliseconds: number): void {
    this.last = null;
    this.whole = milliseconds;
  }

  /** Frames came so fast with all passes that none has to wait. */
  get isSlow(): boolean {
    return this.whole > SLOW;
  }

  /** If frames with all passes come too slowly in motion, the next ones are drawn without. */
  heedMotion(): void {
    if (this.intervals.length >= 3 && this.frameTime > SLOW) this.whole = this.frameTime;
  }

  get framesPerSecond(): number | null {
    const time = this.intervals.length ? this.frameTime : this.whole;
    return time > 0 ? 1000 / time : null;
  }

  private get frameTime(): number {
    return this.intervals.reduce((sum, each) => sum + each, 0) / this.intervals.length;
  }
}
