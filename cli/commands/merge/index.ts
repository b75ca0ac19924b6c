export { declare } from '../merge.ts';
