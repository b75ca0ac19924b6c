export { createPack, type Pack } from './pack.ts';
export type { Best, PackLevel, PackStorage } from './types.ts';
