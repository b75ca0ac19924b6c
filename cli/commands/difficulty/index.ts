export { declare } from '../difficulty.ts';
