export { AstronautLayer, scaleIn } from './astronaut-layer.ts';
export { type Line, linesOf } from './ghost-lines.ts';
export { fillSquares } from './heat.ts';
export { ObjectLayer } from './object-layer.ts';
export { OverlayLayer } from './overlay-layer.ts';
export { Rings } from './rings.ts';
export { SpaceScene } from './space-scene.ts';
export { WayLayer } from './way-layer.ts';
