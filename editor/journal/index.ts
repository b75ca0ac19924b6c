export { openIndexedDbStore } from './indexed-db-store.ts';
export { createJournal, type Journal, type Keeping, type LevelJournal, type Recovery } from './journal.ts';
export type { JournalStore } from './journal-store.ts';
export { createMemoryStore } from './memory-store.ts';
