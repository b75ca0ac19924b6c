import { CANVAS_LAYERS, type LayerSwitch } from '../core/session/index.ts';
import { FEATURES } from '../features/index.ts';

/** All layers over the level that can be shown and hidden. */
export const LAYERS: readonly LayerSwitch[] = [...CANVAS_LAYERS, ...FEATURES.flatMap(({ layers }) => layers ?? [])];
