export { declare } from './plan.ts';
