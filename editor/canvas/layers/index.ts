export { AstronautLayer } from './astronaut-layer.ts';
export { DeathLayer } from './death-layer.ts';
export { LostLayer } from './lost-layer.ts';
export { ObjectLayer } from './object-layer.ts';
export { OverlayLayer } from './overlay-layer.ts';
export { RaceLayer } from './race-layer.ts';
export { SearchLayer, type SearchPicture } from './search-layer.ts';
export { SpaceScene } from './space-scene.ts';
export { WayLayer } from './way-layer.ts';
