/**
 * Calls back with every frame of the page.
 * @param rate simulated seconds per second
 * @param onFrame is given the simulated time since the last frame and the time of this one, ms
 * @returns stops it
 */
export function everyFrame(rate: () => number, onFrame: (ms: number, now: number) => void): () => void {
  let last = performance.now();
  const next = (now: number) => {
    frame = requestAnimationFrame(next);
    const ms = (now - last) * rate();
    last = now;
    onFrame(ms, now);
  };
  let frame = requestAnimationFrame(next);
  return () => cancelAnimationFrame(frame);
}
