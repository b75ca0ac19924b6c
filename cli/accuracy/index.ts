export { type Diagram, type DiagramPoint, drawDiagram } from './diagram.ts';
export type { Ground } from './ink.ts';
export { levelDiagram, linesOf, noteOf } from './level-diagram.ts';
export { type AccuracyReport, accuracyJson } from './report.ts';
export { accuracyPretty, brief } from './table.ts';
export { drawTunnelling, type TunnellingCurve } from './tunnelling.ts';
