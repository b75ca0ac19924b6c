export { AstronautLayer, scaleIn } from './astronaut-layer.ts';
export { dashesOf, lengthAlong, strokesOf } from './dashes.ts';
export { ObjectLayer } from './object-layer.ts';
export { OverlayLayer } from './overlay-layer.ts';
export { Rings } from './rings.ts';
export { SpaceScene, starsOf } from './space-scene.ts';
export { linesOf, WayLayer } from './way-layer.ts';
