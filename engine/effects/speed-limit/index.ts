export { speedLimit } from './speed-limit.ts';
