export { collect, minerals } from './minerals.ts';
