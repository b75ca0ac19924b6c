export { centralSeries } from './central-series.ts';
export { chaserSeries } from './chaser-series.ts';
export { DRIFTS, IS_BASE, placeChaser, placeCircle, placeRock, relativeAt, relativeSeries, SERIES } from './circle.ts';
export { CENTRAL, COAST, Flow, isInCentre, LINEAR, SLIDE, STEADY } from './flow.ts';
export { rebase } from './frame.ts';
export type { Glide, Integrator } from './integrator.ts';
export {
  beginLine,
  bendLine,
  findLine,
  holdsTarget,
  keepSteadyLine,
  movesAlong,
  ontoLine,
  sideOf,
  straighten,
  straightenBody,
} from './line.ts';
export {
  actingForce,
  awakeAt,
  type CentralForce,
  type Chase,
  type ChaserCircles,
  type Crowd,
  type EventRule,
  GOES_ON,
  MODES,
  Motion,
  moveBy,
  type Parts,
  type Recorder,
  type SteadyForce,
} from './motion.ts';
export { distanceSquared, nearest } from './nearest.ts';
export { PackedPieces } from './packed-pieces.ts';
export { chaserPlaceAt, directionAt, lookAt, placeAt, rockAt, settleAndTurnAt } from './places.ts';
export { addProduct, pairAt, shift, valueAt } from './polynomial.ts';
export { drivenSeries, LONGEST_SERIES, linearSeries, TAYLOR_DEGREE, taylorStep } from './power-series.ts';
export { expandSlide } from './rim-piece.ts';
export { layOutRocks, readRocks, stir, targetsAround } from './rocks.ts';
export { ALERTNESS, LINES, MEETINGS, ONSETS, PIECE_END, RECORDS, SLOTS, TURNS } from './state.ts';
