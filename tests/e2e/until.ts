import { vi } from 'vitest';

/** ms: nothing takes so long, on a busy machine either */
export const PATIENCE = 120_000;

/** Waits until what is expected is so; says what was found instead when that is never. */
export const until = <T>(look: () => T | Promise<T>): Promise<T> => vi.waitFor(look, { timeout: PATIENCE, interval: 30 });
