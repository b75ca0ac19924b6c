import { type RefObject, useEffect, useRef } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { useEditor, usePageTheme, useSession } from '../core/context/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { ticksOf, toLevel, type View } from './view.ts';

interface RulersProps {
  readonly canvas: StoreApi<CanvasState>;
  /** The element of the canvas. */
  readonly host: RefObject<HTMLElement | null>;
}

/** px of screen across a ruler */
const THICK = 18;

/** Draws the ticks along one side; along the left one, numbers stand upright beside their ticks. */
function draw(element: HTMLCanvasElement, view: View, axis: 'x' | 'y'): void {
  const ratio = window.devicePixelRatio;
  const length = axis === 'x' ? view.width : view.height;
  const [width, height] = axis === 'x' ? [length, THICK] : [THICK, length];
  element.width = Math.round(width * ratio);
  element.height = Math.round(height * ratio);
  const context = element.getContext('2d');
  if (context === null) return;
  const { color, fontFamily } = getComputedStyle(element);
  context.scale(ratio, ratio);
  context.strokeStyle = color;
  context.fillStyle = color;
  context.font = `10px ${fontFamily}`;
  context.beginPath();
  const from = toLevel(view, { x: 0, y: 0 })[axis];
  for (const { value, at, isLong } of ticksOf(from, length, view.zoom)) {
    const px = Math.round(at) + 0.5;
    const start = isLong ? 0 : THICK - 5;
    if (axis === 'x') context.moveTo(px, start);
    else context.moveTo(start, px);
    context.lineTo(axis === 'x' ? px : THICK, axis === 'x' ? THICK : px);
    if (!isLong) continue;
    context.save();
    context.translate(axis === 'x' ? px + 3 : 9, axis === 'x' ? 9 : px + 3);
    if (axis === 'y') context.rotate(Math.PI / 2);
    context.fillText(String(value), 0, axis === 'y' ? 4 : 0);
    context.restore();
  }
  context.stroke();
}

/** Rulers in px of the level along the top and the left, on which the pointer's place is marked. */
export function Rulers({ canvas, host }: RulersProps) {
  const { settings } = useEditor();
  const isOn = useStore(settings, (state) => state.rulers);
  const isEditing = useSession(({ mode }) => mode === 'edit');
  return isOn && isEditing ? <ShownRulers canvas={canvas} host={host} /> : null;
}

function ShownRulers({ canvas, host }: RulersProps) {
  const view = useStore(canvas, (state) => state.view);
  const theme = usePageTheme();
  const top = useRef<HTMLCanvasElement>(null);
  const left = useRef<HTMLCanvasElement>(null);
  const across = useRef<HTMLSpanElement>(null);
  const down = useRef<HTMLSpanElement>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another theme, other colours
  useEffect(() => {
    if (top.current !== null) draw(top.current, view, 'x');
    if (left.current !== null) draw(left.current, view, 'y');
  }, [view, theme]);
  useEffect(() => {
    const element = host.current;
    if (element === null) return;
    const stopping = new AbortController();
    // the marks are moved without rendering anything
    const follow = ({ clientX, clientY }: PointerEvent) => {
      const box = element.getBoundingClientRect();
      if (across.current !== null) across.current.style.transform = `translateX(${clientX - box.left}px)`;
      if (down.current !== null) down.current.style.transform = `translateY(${clientY - box.top}px)`;
    };
    element.addEventListener('pointermove', follow, { signal: stopping.signal, passive: true });
    return () => stopping.abort();
  }, [host]);
  return (
    <div className="rulers" aria-hidden>
      <canvas ref={top} className="rulers__top" style={{ width: view.width }} />
      <canvas ref={left} className="rulers__left" style={{ height: view.height }} />
      <span ref={across} className="rulers__across" />
      <span ref={down} className="rulers__down" />
    </div>
  );
}
