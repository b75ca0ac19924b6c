export { gapAt, offerContact, sweptTime } from './contact.ts';
export {
  chaserTravel,
  distanceToNear,
  farthestRockTravel,
  listRims,
  listTouching,
  ownTravel,
  refresh,
  rockDistanceToNear,
  rockTravel,
  sortNeighbours,
  targetsNear,
} from './neighbourhood.ts';
export { isClear, quietAtRim, quietOutside, quietTime, quietWithin } from './quiet.ts';
export { rimTime } from './rim.ts';
export { crossing, lookNext, overlapBetween, PATIENCE, safeStep, safeStretch, smallestStride } from './roots.ts';
export { eventRule, justFired, layOutRules, offer, offerFrom } from './rule.ts';
