export { type CheckedPack, checkPackFile } from './check-pack-file.ts';
export { orderFiles } from './order-files.ts';
export { readPackFile } from './read-pack-file.ts';
