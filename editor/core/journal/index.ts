export { createJournal, type Journal, type Recovery } from './journal.ts';
export { createMemoryStore, isQuota, type JournalStore, openIndexedDbStore } from './journal-store.ts';
export type { Keeping, LevelJournal } from './level-journal.ts';
