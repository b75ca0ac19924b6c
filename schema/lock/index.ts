// The results that were agreed on.
export {
  formatLock,
  formatLockJsonSchema,
  LOCK_NAME,
  LOCK_VERSION,
  type Lock,
  type LockEntry,
  lockEntrySchema,
  lockJsonSchema,
  lockSchema,
} from './lock.ts';
export { type LockReading, readLock } from './read-lock.ts';
