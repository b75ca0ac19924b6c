export { declare } from '../verify.ts';
