export { winds } from './winds.ts';
