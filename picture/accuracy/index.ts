export type { Ground } from '../ink.ts';
export { type Diagram, type DiagramPoint, drawDiagram } from './diagram.ts';
export { levelDiagram, linesOf, noteOf } from './level-diagram.ts';
export { drawTunnelling, type TunnellingCurve } from './tunnelling.ts';
