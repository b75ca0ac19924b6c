import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import {
  COLOURS,
  type Colours,
  colourNumber,
  type Drawing,
  deathOpacity,
  fillSquares,
  type OnCanvas,
  type Point,
  ShadeLegend,
  toLevel,
  toScreen,
} from '../../canvas/index.ts';
import { useLevel, usePageTheme, useSession } from '../../core/context/index.ts';
import { type DeathMap, deathsNear, shelfOf } from '../../core/shelf/index.ts';
import './plays.css';
import type { GameObjects, Scene } from 'phaser';
import { plural } from '../../../check/words/index.ts';

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

/** The legend of the heat map of deaths. Empty while the map is not shown. */
export function DeathLegend() {
  const deaths = useStore(shelfOf(useLevel()).store, (state) => state.deaths);
  const isShown = useSession(({ layers, mode }) => layers.deaths && mode === 'edit');
  const theme = usePageTheme();
  if (deaths === null || !isShown) return null;
  return (
    <ShadeLegend
      label="Heat map of deaths"
      caption={`${plural(deaths.deaths, 'death')}, counted in squares of ${deaths.cellSize} px`}
      map={deaths}
      colour={COLOURS[theme].death}
      opacityOf={deathOpacity}
      corner="right"
    />
  );
}

/** The heat map of deaths: squares above space, below the objects. */
export class DeathLayer implements Drawing<DeathMap | null> {
  private readonly graphics: GameObjects.Graphics;

  constructor(
    scene: Scene,
    private readonly colours: Colours,
  ) {
    this.graphics = scene.add.graphics().setDepth(0.3);
  }

  /** @param deaths null: none are shown */
  show(deaths: DeathMap | null): void {
    this.graphics.clear();
    if (deaths !== null) fillSquares(this.graphics, deaths, colourNumber(this.colours.death), deathOpacity);
  }

  destroy(): void {
    this.graphics.destroy();
  }
}
