export type { Beside, OnTimeline, TimelinePart } from './part.ts';
export { toX } from './scale.ts';
export { Timeline } from './Timeline.tsx';
export { looksLike } from './TimelineLegend.tsx';
