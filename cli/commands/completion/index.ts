export { declare } from './completion.ts';
