export { type Box, boxOf, DEFAULT_BOX } from './box.ts';
export { boxCircleGap, boxOverlapsCircle } from './box-circle.ts';
export { circlesOverlap } from './circle-circle.ts';
