import type { SessionStore } from '../core/session/index.ts';

/**
 * Plays the run in the timeline while `isPlayingBack` is set; stops at its end.
 * @param end the last tick of the shown run
 * @returns stops it
 */
export function followPlayback(session: SessionStore, end: () => number): () => void {
  let frame = 0;
  let last = 0;
  const onFrame = (now: number) => {
    const { isPlayingBack, tick, rate } = session.getState();
    // Requested before the session changes: the subscriber must see that a frame is pending.
    frame = isPlayingBack ? requestAnimationFrame(onFrame) : 0;
    if (!isPlayingBack) return;
    const next = tick + ((now - last) / 1000) * 60 * rate;
    last = now;
    if (next >= end()) session.setState({ tick: end(), isPlayingBack: false });
    else session.setState({ tick: next });
  };
  const stop = session.subscribe(({ isPlayingBack }) => {
    if (!isPlayingBack || frame !== 0) return;
    last = performance.now();
    frame = requestAnimationFrame(onFrame);
  });
  return () => {
    stop();
    cancelAnimationFrame(frame);
  };
}
