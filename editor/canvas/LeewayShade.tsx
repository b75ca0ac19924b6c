import { useEffect, useRef, useState } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { useLevel, usePageTheme, useSession } from '../context/index.ts';
import { leewayOf, type ShadeRect, shapesOf } from '../leeway/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { COLOURS } from './colours.ts';
import { drawLeeway } from './draw-leeway.ts';
import { toScreen } from './view.ts';

/** px of screen between samples from which on each is marked */
const APART = 14;
/** the largest width and height of the picture, px */
const MOST = 2400;
/** The picture is drawn anew when the zoom differs from its own by more than this factor. */
const STRETCH = 1.5;

/** What was drawn last. */
interface Drawn {
  readonly frame: ShadeRect;
  /** px of the picture per px of the level */
  readonly scale: number;
  readonly zoom: number;
}

/**
 * The shade of the places where the selection may stand. It is drawn when something new is known; a view that moves only moves the
 * picture, and costs nothing.
 */
export function LeewayShade({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const answer = useStore(leewayOf(useLevel()), (state) => state.answer);
  const isShown = useSession(({ layers, mode }) => layers.leeway && mode === 'edit') && answer !== null;
  const theme = usePageTheme();
  const view = useStore(canvas, (state) => state.view);
  const picture = useRef<HTMLCanvasElement>(null);
  const [drawn, setDrawn] = useState<Drawn | null>(null);
  const isStretched = drawn !== null && Math.abs(Math.log(view.zoom / drawn.zoom)) > Math.log(STRETCH);
  // the zoom for which it is drawn
  const zoom = drawn === null || isStretched ? view.zoom : drawn.zoom;
  const leeway = answer?.leeway ?? null;
  useEffect(() => {
    const element = picture.current;
    if (element === null || leeway === null || !isShown) return;
    const shapes = shapesOf(leeway, APART / zoom);
    const { frame } = shapes;
    if (frame === null) return;
    const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
    const sharp = Math.min(2, window.devicePixelRatio);
    const scale = Math.min(zoom * sharp, MOST / width, MOST / height);
    element.width = Math.max(1, Math.ceil(width * scale));
    element.height = Math.max(1, Math.ceil(height * scale));
    const { leeway: colour, danger, label } = COLOURS[theme];
    drawLeeway(element, shapes, { scale, density: scale / zoom, colour, bad: danger, open: label });
    setDrawn({ frame, scale, zoom });
  }, [leeway, isShown, theme, zoom]);
  if (!isShown) return null;
  const corner = drawn === null ? { x: 0, y: 0 } : toScreen(view, { x: drawn.frame.left, y: drawn.frame.top });
  const grown = drawn === null ? 1 : view.zoom / drawn.scale;
  return (
    <div className="canvas__leeway" aria-hidden>
      <canvas ref={picture} style={{ transform: `translate(${corner.x}px, ${corner.y}px) scale(${grown})` }} />
    </div>
  );
}
