export { declare } from '../solve.ts';
