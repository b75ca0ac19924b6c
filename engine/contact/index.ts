export { boxCircleGap, boxOverlapsCircle } from './box-circle.ts';
export { circlesOverlap } from './circle-circle.ts';
