import { memo, useEffect, useLayoutEffect, useRef, useState } from 'react';
import type { Partings } from '../../check/runs/index.ts';
import { usePageTheme } from '../core/context/index.ts';
import type { LiveProof } from '../core/proof/index.ts';
import { type Scale, toX } from './scale.ts';

interface GraphsProps {
  readonly margins: LiveProof['margins'];
  readonly scale: Scale;
  readonly width: number;
  readonly height: number;
  /** How far the compared run is at every tick, px; null: no run is compared. */
  readonly apart: Apart | null;
}

/** The distance of a compared run. */
export interface Apart {
  readonly name: string;
  readonly distances: Float64Array;
  readonly partings: Partings;
}

/** Clearances above this, in px, are drawn alike. */
const FAR = 150;

/** px: smaller distances than this never fill the graph. */
const LEAST_FAR = 10;

const farthestOf = ({ distances }: Apart): number =>
  Math.ceil(distances.reduce((most, distance) => Math.max(most, distance), LEAST_FAR));

/** The distance of a compared run is dotted. */
const DOTS = [2, 3];

/** Clearance is dashed, so that the lines differ in more than colour; px. */
const DASHES = [6, 3];

/** The colours of the page's theme. Reading them makes the browser restyle the whole page, so it is done once per theme. */
function lookOf(element: Element) {
  const style = getComputedStyle(element);
  const colour = (name: string) => style.getPropertyValue(name);
  return { speed: colour('--accent'), gap: colour('--warn'), miss: colour('--bad'), apart: colour('--text') };
}

const fastestOf = ({ speed, gap }: GraphsProps['margins']): number => {
  let fastest = 1;
  for (let tick = 0; tick < gap.length; tick++) fastest = Math.max(fastest, speed[tick]);
  return fastest;
};

const hasHazards = ({ gap }: GraphsProps['margins']): boolean => gap.length > 0 && Number.isFinite(gap[0]);

/** Speed and clearance along the run, one below the other, with a key above them. */
export const Graphs = memo(function Graphs({ margins, scale, width, height, apart }: GraphsProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const theme = usePageTheme();
  const [look, setLook] = useState<ReturnType<typeof lookOf> | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another theme has other colours
  useLayoutEffect(() => {
    if (canvas.current !== null) setLook(lookOf(canvas.current));
  }, [theme]);
  const fastest = fastestOf(margins);
  const hazards = hasHazards(margins);
  const farthest = apart === null ? LEAST_FAR : farthestOf(apart);
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
    const half = height / (apart === null ? 2 : 3);
    const first = Math.max(0, Math.floor(scale.from));
    const seen = Math.ceil(scale.from + width / scale.zoom);
    const last = Math.min(count - 1, seen);
    // one point per px is enough
    const stride = Math.max(1, Math.floor(0.5 / scale.zoom));
    const line = (value: (tick: number) => number, top: number, size: number, stroke: string, dashes: number[], to = last) => {
      brush.strokeStyle = stroke;
      brush.lineWidth = 1.5;
      brush.setLineDash(dashes);
      brush.beginPath();
      for (let tick = first; tick <= to; tick += stride) brush.lineTo(toX(scale, tick), top + size * (1 - value(tick)));
      brush.stroke();
    };
    line((tick) => speed[tick] / fastest, 2, half - 6, look.speed, []);
    if (apart !== null) {
      const { distances, partings } = apart;
      const at = (tick: number) => distances[tick] / farthest;
      const top = 2 * half + 2;
      line(at, top, half - 6, look.apart, DOTS, Math.min(distances.length - 1, seen));
      // where they part, and where they meet again
      brush.setLineDash([]);
      brush.fillStyle = look.apart;
      const ticks = [...(partings.parts === null ? [] : [partings.parts]), ...partings.meets.map(({ tick }) => tick)];
      for (const tick of ticks) brush.fillRect(toX(scale, tick) - 1, top, 2, half - 4);
    }
    if (!hazards) return;
    line((tick) => Math.min(1, Math.max(0, gap[tick]) / FAR), half + 2, half - 6, look.gap, DASHES);
    brush.fillStyle = look.miss;
    for (const miss of nearMisses) {
      brush.beginPath();
      brush.arc(toX(scale, miss.tick), half + 2 + (half - 6) * (1 - Math.min(1, Math.max(0, miss.gap) / FAR)), 3, 0, 2 * Math.PI);
      brush.fill();
    }
  }, [margins, scale, width, height, look, fastest, hazards, apart, farthest]);

  const least = margins.nearMisses.reduce((low, { gap }) => Math.min(low, gap), Number.POSITIVE_INFINITY);
  const words = Number.isFinite(least) ? `nearest miss ${least.toFixed(1)} px` : 'no near miss';
  return (
    <>
      <div className="graphs__key" aria-hidden>
        <span className="legend__look legend__look--speed" />
        <span>
          speed<span className="graphs__scale">, to {Math.round(fastest)} px/s</span>
        </span>
        {hazards && <span className="legend__look legend__look--gap" />}
        <span>
          {hazards ? 'clearance' : 'no hazards in this level'}
          {hazards && <span className="graphs__scale">, to {FAR} px</span>}
        </span>
        {apart !== null && (
          <>
            <span className="legend__look legend__look--apart" />
            <span className="graphs__apart">
              distance to {apart.name}
              <span className="graphs__scale">, to {farthest} px</span>
            </span>
          </>
        )}
        {Number.isFinite(least) && (
          <>
            <span className="legend__look legend__look--near" />
            <span>near miss</span>
          </>
        )}
      </div>
      <canvas
        ref={canvas}
        className="graphs"
        style={{ height }}
        role="img"
        aria-label={`Speed and clearance along the run: ${words}, top speed ${Math.round(fastest)} px/s${apart === null ? '' : `; distance to ${apart.name} below`}`}
      />
    </>
  );
});
