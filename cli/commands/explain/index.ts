export { declare, EXPLAINED_CODES } from './explain.ts';
