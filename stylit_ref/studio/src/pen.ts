// What a pointer tells about itself.

/** Where a pen is, in pixels of the painting, and how it is held. */
export interface Sample {
  x: number;
  y: number;
  /** From 0 to 1; 1 for what knows no pressure. */
  pressure: number;
  /** From 0, upright, to 1, lying. */
  lean: number;
  /** Where it leans to, in radians. */
  azimuth: number;
}

export function sampleOf(event: PointerEvent, place: [number, number]): Sample {
  const isPen = event.pointerType === "pen";
  const [lean, azimuth] = isPen ? leanOf(event) : [0, 0];
  return { x: place[0], y: place[1], pressure: isPen ? event.pressure : 1, lean, azimuth };
}

/** Every place of a pointer since its last event, where the browser tells. */
export function coalesced(event: PointerEvent): PointerEvent[] {
  const events = "getCoalescedEvents" in event ? event.getCoalescedEvents() : [];
  return events.length ? events : [event];
}

function leanOf(event: PointerEvent): [number, number] {
  if (event.altitudeAngle !== undefined) return [1 - event.altitudeAngle / (Math.PI / 2), event.azimuthAngle];
  const [x, y] = [event.tiltX, event.tiltY].map((tilt) => Math.tan((Math.min(Math.max(tilt, -89), 89) * Math.PI) / 180));
  return [Math.atan(Math.hypot(x, y)) / (Math.PI / 2), Math.atan2(y, x)];
}
