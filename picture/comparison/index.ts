export { type Comparison, type Mark, pathOf, renderComparison } from './draw-comparison.ts';
