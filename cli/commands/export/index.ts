export { declare } from './export.ts';
