import type { Layer } from './layer.ts';

/** What is told on the way, for tests and pictures. */
export interface OrbitWatch {
  /** Called with the boxes at the start of each step, which is numbered from 0. */
  readonly layer?: (layer: Layer, step: number) => void;
  /** Called with rectangles that contain the places of a part of a step: least and greatest x and y, px from the start. */
  readonly places?: (x0: number, x1: number, y0: number, y1: number) => void;
}
