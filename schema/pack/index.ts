// The order in which levels are played.
export { PACK_NAME, PACK_VERSION } from './limits.ts';
export { formatPack, levelOfEntry, levelsOfPack, type PackEntry, type PackFile } from './pack.ts';
export { packSchema } from './pack-schema.ts';
export { type PackReading, readPack } from './read-pack.ts';
