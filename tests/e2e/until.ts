import { vi } from 'vitest';

/** ms; nothing takes this long, even on a busy machine */
export const PATIENCE = 120_000;

/** Waits until an expectation holds; otherwise throws its last error. */
export const until = <T>(look: () => T | Promise<T>): Promise<T> => vi.waitFor(look, { timeout: PATIENCE, interval: 30 });
