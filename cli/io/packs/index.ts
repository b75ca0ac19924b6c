export { type Batch, type Contents, sizeOf } from './batch.ts';
export { type Entry, entriesOf } from './entries.ts';
export { firstPack, packFormat } from './formats.ts';
export { entryName, readEntry } from './read-entry.ts';
export { readSet } from './read-set.ts';
