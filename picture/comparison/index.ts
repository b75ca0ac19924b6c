export { type Comparison, type ComparisonOptions, type Mark, pathOf, renderComparison } from './draw-comparison.ts';
