export { LeewayLegend } from './LeewayLegend.tsx';
export { type LeewayShapes, type ShadeRect, shapesOf } from './leeway-picture.ts';
export { leewayOf } from './leeway-store.ts';
export { LEEWAY_KEY, watchLeeway } from './watch-leeway.ts';
