// The order in which levels are played.
export { formatPack, levelOfEntry, levelsOfPack, PACK_NAME, PACK_VERSION, type PackEntry, type PackFile } from './pack.ts';
export { packSchema } from './pack-schema.ts';
export { type PackReading, readPack } from './read-pack.ts';
