export { blackHole, touchBlackHole } from './black-hole.ts';
