export { gun } from './gun.ts';
export { recordTarget } from './target.ts';
