export { blackHole } from './black-hole.ts';
