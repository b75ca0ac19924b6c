export { crossing, overlapBetween } from './bracket.ts';
export { isClear } from './clear.ts';
export { lookNext, PATIENCE, safeStep, safeStretch, smallestStride } from './conservative-advancement.ts';
export { gapAt, offerContact, sweptTime } from './contact.ts';
export { justFired, offer, offerAs } from './first-event.ts';
export {
  chaserTravel,
  distanceToNear,
  eachTargetNear,
  farthestRockTravel,
  listRims,
  listTouching,
  ownTravel,
  refresh,
  rockDistanceToNear,
  rockTravel,
} from './neighbourhood.ts';
export { quietAtRim, quietOutside, quietTime, quietWithin } from './quiet.ts';
export { rimTime } from './rim.ts';
export { eventRule, layOutRules } from './rule.ts';
