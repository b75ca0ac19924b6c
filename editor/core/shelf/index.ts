export * from './given.ts';
export { type DeathMap, deathsNear, hashNow, type OpenedPlay, shelfOf } from './shelf.ts';
