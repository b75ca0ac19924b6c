import type { Feature } from '../feature.ts';
import { followPlaces, takePlace } from './follow-places.ts';

/** Links to a place of a level: a run, a tick. */
export const places: Feature = {
  name: 'places',
  openNamed(editor) {
    followPlaces(editor);
    return takePlace(editor);
  },
};
