export { recoil } from './recoil.ts';
