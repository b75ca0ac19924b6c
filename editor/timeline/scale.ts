/** Which ticks the timeline shows, and where. */
export interface Scale {
  /** The tick at the left end. */
  readonly from: number;
  /** px of screen per tick of 1/60 s */
  readonly zoom: number;
}

/** px per tick */
export const SCALE_LIMITS = { least: 0.05, most: 24 } as const;

export const toX = ({ from, zoom }: Scale, tick: number): number => (tick - from) * zoom;
export const toTick = ({ from, zoom }: Scale, x: number): number => from + x / zoom;

/** Shows ticks 0 to `ticks` on `width` px, with a little room after the end. */
export function fitTicks(ticks: number, width: number): Scale {
  const zoom = width / (1.06 * Math.max(60, ticks));
  return { from: 0, zoom: Math.min(SCALE_LIMITS.most, Math.max(SCALE_LIMITS.least, zoom)) };
}

/** Zooms and keeps the tick under `x` in place. */
export function zoomScale(scale: Scale, x: number, factor: number): Scale {
  const zoom = Math.min(SCALE_LIMITS.most, Math.max(SCALE_LIMITS.least, scale.zoom * factor));
  return { zoom, from: Math.max(0, toTick(scale, x) - x / zoom) };
}

/** Moves the view by `dx` px. */
export function panScale(scale: Scale, dx: number): Scale {
  return { ...scale, from: Math.max(0, scale.from - dx / scale.zoom) };
}

/** Ticks between two labels of the ruler, at least `room` px apart: 0.1, 0.5, 1, 5, 10 s and so on. */
export function rulerStep({ zoom }: Scale, room: number): number {
  const steps = [6, 30, 60, 300, 600, 1800, 3600];
  return steps.find((step) => step * zoom >= room) ?? 36_000;
}
