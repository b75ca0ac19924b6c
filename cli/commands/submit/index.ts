export { declare } from '../submit.ts';
