export { type Batch, type Contents, sizeOf, type Entry, entriesOf, firstPack, packFormat } from './batch.ts';
export { entryName, readEntry, readSet } from './read-set.ts';
