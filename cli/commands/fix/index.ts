export { declare } from './fix.ts';
