export { type Lattice, latticeFor, type MovedObject, movedLevel, shiftTo } from './moved-level.ts';
export * from './survey.ts';
