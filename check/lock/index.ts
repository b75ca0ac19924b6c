export { entryChange, isAgreed, resultChange } from './compare.ts';
