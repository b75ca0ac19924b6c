import type { SessionStore } from '../session/index.ts';

/**
 * Lets the timeline play the run by itself while `rolling` is set; stops at its end.
 * @param end the last tick of the shown run
 * @returns stops it
 */
export function rollTimeline(session: SessionStore, end: () => number): () => void {
  let frame = 0;
  let last = 0;
  const onFrame = (now: number) => {
    const { rolling, tick, rate } = session.getState();
    // asked for before the session is told: its subscriber must see that a frame is on its way
    frame = rolling ? requestAnimationFrame(onFrame) : 0;
    if (!rolling) return;
    const next = tick + ((now - last) / 1000) * 60 * rate;
    last = now;
    if (next >= end()) session.setState({ tick: end(), rolling: false });
    else session.setState({ tick: next });
  };
  const stop = session.subscribe(({ rolling }) => {
    if (!rolling || frame !== 0) return;
    last = performance.now();
    frame = requestAnimationFrame(onFrame);
  });
  return () => {
    stop();
    cancelAnimationFrame(frame);
  };
}
