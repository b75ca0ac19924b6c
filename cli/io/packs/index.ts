export { type Batch, type Contents, type Entry, entriesOf, firstPack, packFormat, sizeOf } from './batch.ts';
export { entryName, readEntry, readSet } from './read-set.ts';
