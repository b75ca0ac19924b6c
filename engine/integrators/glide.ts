import { type Flow, type Glide, isInCentre, LINEAR, ontoLine } from '../motion/index.ts';
import { closePass, untilGrid } from './fixed-step.ts';

const end4 = new Float64Array(4);

/** A whole step of `h` s: writes place and velocity at its end to out[0..3]. */
export type Whole = (flow: Flow, x: Float64Array, y: Float64Array, h: number, out: Float64Array) => void;

/** Glides by making one step after the other. */
export function glideBy(whole: Whole): Glide {
  return (flow, x, y, start, end, rate, count) => {
    let time = start;
    for (;;) {
      const h = closePass(flow, x, y, untilGrid(time, rate));
      // a step so short that it does not change the time would not end by `end`
      if (!(time + h <= end && time + h > time) || isInCentre(flow, x, y)) return time;
      if (flow.kind === LINEAR) flow.moveTo(x[0], y[0]);
      whole(flow, x, y, h, end4);
      if (flow.kind === LINEAR) ontoLine(flow.steep, flow.slope, end4, 0);
      x[0] = end4[0];
      y[0] = end4[1];
      x[1] = end4[2];
      y[1] = end4[3];
      time += h;
      count[0]++;
    }
  };
}
