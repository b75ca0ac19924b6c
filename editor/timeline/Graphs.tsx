import { memo, useEffect, useLayoutEffect, useRef, useState } from 'react';
import { usePageTheme } from '../context/index.ts';
import type { LiveProof } from '../proof/index.ts';
import { type Scale, toX } from './scale.ts';

interface GraphsProps {
  readonly margins: LiveProof['margins'];
  readonly scale: Scale;
  readonly width: number;
  readonly height: number;
}

/** Clearances above this are all the same to the eye, px. */
const FAR = 150;

/** Colours and letters of the page's theme. Asking for them makes the browser style the whole page, so it is done once a theme. */
function lookOf(element: Element) {
  const style = getComputedStyle(element);
  const colour = (name: string) => style.getPropertyValue(name);
  return {
    speed: colour('--accent'),
    gap: colour('--warn'),
    miss: colour('--bad'),
    words: colour('--quiet'),
    ground: colour('--panel'),
    font: `11px ${style.fontFamily}`,
  };
}

/** Speed and clearance along the run, one above the other. */
export const Graphs = memo(function Graphs({ margins, scale, width, height }: GraphsProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const theme = usePageTheme();
  const [look, setLook] = useState<ReturnType<typeof lookOf> | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another theme has other colours
  useLayoutEffect(() => {
    if (canvas.current !== null) setLook(lookOf(canvas.current));
  }, [theme]);
  useEffect(() => {
    const element = canvas.current;
    const brush = element?.getContext('2d');
    if (element === null || !brush || look === null) return;
    const dots = devicePixelRatio;
    element.width = Math.max(1, Math.round(width * dots));
    element.height = Math.max(1, Math.round(height * dots));
    brush.scale(dots, dots);
    const { gap, speed, nearMisses } = margins;
    const count = gap.length;
    const half = height / 2;
    const first = Math.max(0, Math.floor(scale.from));
    const last = Math.min(count - 1, Math.ceil(scale.from + width / scale.zoom));
    // a point a px is enough for the eye
    const stride = Math.max(1, Math.floor(0.5 / scale.zoom));
    const line = (value: (tick: number) => number, top: number, size: number, stroke: string) => {
      brush.strokeStyle = stroke;
      brush.lineWidth = 1.5;
      brush.beginPath();
      for (let tick = first; tick <= last; tick += stride) brush.lineTo(toX(scale, tick), top + size * (1 - value(tick)));
      brush.stroke();
    };
    let fastest = 1;
    for (let tick = 0; tick < count; tick++) fastest = Math.max(fastest, speed[tick]);
    line((tick) => speed[tick] / fastest, 2, half - 6, look.speed);
    const hazards = count > 0 && Number.isFinite(gap[0]);
    if (hazards) line((tick) => Math.min(1, Math.max(0, gap[tick]) / FAR), half + 2, half - 6, look.gap);
    brush.fillStyle = look.miss;
    for (const miss of nearMisses) {
      brush.beginPath();
      brush.arc(toX(scale, miss.tick), half + 2 + (half - 6) * (1 - Math.min(1, Math.max(0, miss.gap) / FAR)), 3, 0, 2 * Math.PI);
      brush.fill();
    }
    brush.fillStyle = look.words;
    brush.font = look.font;
    brush.strokeStyle = look.ground;
    brush.lineWidth = 4;
    brush.lineJoin = 'round';
    const label = (text: string, y: number) => {
      // a rim in the colour of the ground keeps it apart from the lines
      brush.strokeText(text, 4, y);
      brush.fillText(text, 4, y);
    };
    label(`speed, to ${Math.round(fastest)} px/s`, half - 4);
    label(hazards ? `clearance, to ${FAR} px` : 'nothing deadly in this level', height - 4);
  }, [margins, scale, width, height, look]);

  const least = margins.nearMisses.reduce((low, { gap }) => Math.min(low, gap), Number.POSITIVE_INFINITY);
  const words = Number.isFinite(least) ? `nearest pass ${least.toFixed(1)} px` : 'no close pass';
  return <canvas ref={canvas} className="graphs" role="img" aria-label={`Speed and clearance along the run: ${words}`} />;
});
