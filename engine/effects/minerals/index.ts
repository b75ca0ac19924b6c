export { minerals } from './minerals.ts';
