// The results that were agreed on.
export * from './lock.ts';
export { type LockReading, readLock } from './read-lock.ts';
