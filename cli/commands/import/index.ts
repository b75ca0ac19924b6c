export { declare } from '../import.ts';
