export { ticksToAgree } from './certified-ticks.ts';
export { entryChange, isAgreed, resultChange } from './compare.ts';
