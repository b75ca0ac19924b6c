export { type Pack, packedLevel, packScript } from './pack.ts';
export { PACK_FILE, pageOf } from './page.ts';
