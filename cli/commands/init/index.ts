export { declare } from '../init.ts';
