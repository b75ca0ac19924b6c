import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { type OnCanvas, type Point, toLevel, toScreen } from '../../canvas/index.ts';
import { useLevel, useSession } from '../../core/context/index.ts';
import { deathsNear, shelfOf } from '../../core/shelf/index.ts';
import './plays.css';

/** px of the level around the pointer in which deaths count, and the least of them on the screen */
const REACH = { level: 12, screen: 10 } as const;

/** lines of the tip */
const LINES = 4;

/** How many players die under the pointer, and why, while the heat map of deaths is shown. */
export function DeathTip({ canvas, host }: OnCanvas) {
  const deaths = useStore(shelfOf(useLevel()).store, (state) => state.deaths);
  const isShown = useSession(({ layers, mode }) => layers.deaths && mode === 'edit') && deaths !== null;
  const view = useStore(canvas, (state) => state.view);
  const [at, setAt] = useState<Point | null>(null);
  useEffect(() => {
    const element = host.current;
    if (element === null || !isShown) return;
    const stopping = new AbortController();
    const follow = (event: PointerEvent) => {
      const { left, top } = element.getBoundingClientRect();
      // a drag changes the level and needs no tip
      const isDrag = event.type === 'pointermove' && event.buttons !== 0;
      setAt(isDrag ? null : toLevel(canvas.getState().view, { x: event.clientX - left, y: event.clientY - top }));
    };
    for (const type of ['pointermove', 'pointerdown'] as const) {
      element.addEventListener(type, follow, { signal: stopping.signal, passive: true });
    }
    element.addEventListener('pointerleave', () => setAt(null), { signal: stopping.signal });
    return () => {
      stopping.abort();
      setAt(null);
    };
  }, [host, canvas, isShown]);
  if (!isShown || at === null) return null;
  const causes = deathsNear(deaths, at.x, at.y, Math.max(REACH.level, REACH.screen / view.zoom));
  if (causes.length === 0) return null;
  const { x, y } = toScreen(view, at);
  const isLeft = x > view.width / 2;
  const isBelow = y < 120;
  return (
    <div
      className="canvas__deaths"
      role="tooltip"
      style={{
        transform: `translate(${x + (isLeft ? -14 : 14)}px, ${y + (isBelow ? 14 : -14)}px) translate(${isLeft ? -100 : 0}%, ${isBelow ? 0 : -100}%)`,
      }}
    >
      {causes.slice(0, LINES).map(({ cause, count }) => (
        <span key={cause}>
          <b className="numbers">{count}×</b> she {cause}
        </span>
      ))}
      {causes.length > LINES && <span>and {causes.length - LINES} other causes</span>}
    </div>
  );
}
