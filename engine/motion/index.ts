export { centralSeries } from './central-series.ts';
export { chaserSeries } from './chaser-series.ts';
export { DRIFTS, IS_BASE, placeChaser, placeCircle, placeRock, relativeAt, relativeSeries, SERIES } from './circle.ts';
export { CENTRAL, COAST, Flow, type Glide, type Integrator, isInCentre, LINEAR, SLIDE, STEADY } from './flow.ts';
export { FOLLOWERS } from './followers.ts';
export * from './line.ts';
export {
  actingForce,
  awakeAt,
  type CentralForce,
  type Chase,
  type ChaserCircles,
  type Crowd,
  type EventRule,
  type Following,
  GOES_ON,
  MODES,
  Motion,
  moveBy,
  type Parts,
  type Recorder,
  type Sliding,
  type SteadyForce,
} from './motion.ts';
export type { Vicinity } from './neighbour-list.ts';
export { PackedPieces } from './packed-pieces.ts';
export { arriveAndTurnAt, chaserPlaceAt, directionAt, lookAt, placeAt, rockAt } from './places.ts';
export { addProduct, pairAt, shift, valueAt } from './polynomial.ts';
export { drivenSeries, LONGEST_SERIES, linearSeries, TAYLOR_DEGREE, taylorStep } from './power-series.ts';
export { ALERTNESS, LINES, MEETINGS, ONSETS, PIECE_END, RECORDS, SLOTS, TURNS } from './state.ts';
export { circlesAround, distanceSquared, layOutRocks, nearest, readRocks, stir, targetsAround } from './targets.ts';
