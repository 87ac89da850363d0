// Work that is worth doing once a frame.

/** A function that asks for `step` in the next frame, however often it is called before. */
export function oncePerFrame(step: () => void): () => void {
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

/** A function that takes a `step` at once, or in the next frame if it took one since the last. */
export function atOnceAndPerFrame(step: () => void): () => void {
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
