export { createJournal, isQuota, type Journal, type Recovery } from './journal.ts';
export { createMemoryStore, type JournalStore, openIndexedDbStore } from './journal-store.ts';
export type { Keeping, LevelJournal } from './level-journal.ts';
