export { openIndexedDbStore } from './indexed-db-store.ts';
export { createJournal, type Journal } from './journal.ts';
export { isQuota } from './journal-state.ts';
export type { JournalStore } from './journal-store.ts';
export type { Keeping, LevelJournal } from './level-journal.ts';
export { createMemoryStore } from './memory-store.ts';
export type { Recovery } from './recovery.ts';
