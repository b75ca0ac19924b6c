export { followPlaces, takePlace } from './follow-places.ts';
