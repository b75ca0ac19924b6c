export { OnionCard } from './OnionCard.tsx';
export { type OnionPicture, onionPictureOf } from './onion-picture.ts';
export { onionOf } from './onion-store.ts';
export { type OnionSession, watchOnion } from './watch-onion.ts';
