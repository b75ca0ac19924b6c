/** Whether work is kept, for the person. */
export type JournalState =
  | { readonly kind: 'working' }
  /** Nothing outlives this page. */
  | { readonly kind: 'missing'; readonly message: string; readonly hint: string }
  /** The last changes could not be kept; it goes on trying with every change. */
  | { readonly kind: 'failing'; readonly message: string; readonly hint: string };

/** Whether the database is full. */
export const isQuota = (error: unknown): boolean => error instanceof Error && error.name === 'QuotaExceededError';

/** How the journal stands after a failure of its database. */
export function failureOf(error: unknown): JournalState {
  if (isQuota(error)) {
    return {
      kind: 'failing',
      message: 'the browser has no room left to keep your changes until they are saved',
      hint: 'save the level, free some space on the disk, or clear the data of other sites',
    };
  }
  const why = error instanceof Error ? error.message : String(error);
  return {
    kind: 'failing',
    message: `the browser could not keep your changes until they are saved: ${why}`,
    hint: 'save the level now',
  };
}
