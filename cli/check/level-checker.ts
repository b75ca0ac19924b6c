import type { checkLevel } from './check-level.ts';

/** Loads what checks a level, and with it the engine: only for the thread that checks. */
export const levelChecker = async (): Promise<typeof checkLevel> => (await import('./check-level.ts')).checkLevel;
