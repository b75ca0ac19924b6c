export { type CheckedPack, checkPackFile, type PackSettings } from './check-pack-file.ts';
export { orderFiles } from './order-files.ts';
export { type PackOnDisk, readPackFile } from './read-pack-file.ts';
