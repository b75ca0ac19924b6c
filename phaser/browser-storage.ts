import type { PackStorage } from '../game/index.ts';

/**
 * Finds the browser's storage, which a browser may refuse: asking for it can throw.
 *
 * @returns `localStorage`, or null where there is none; `createPack` then keeps progress as long as the page lasts
 */
export function browserStorage(): PackStorage | null {
  try {
    return globalThis.localStorage ?? null;
  } catch {
    return null;
  }
}
