export { GunInput } from './gun-input.ts';
