/** Whether work is kept, as the user sees it. */
export type JournalState =
  | { readonly kind: 'working' }
  /** nothing outlives this page */
  | { readonly kind: 'missing'; readonly message: string; readonly hint: string }
  /** the last changes could not be kept; retried with every change */
  | { readonly kind: 'failing'; readonly message: string; readonly hint: string };

/** Whether the database is full. */
export const isQuota = (error: unknown): boolean => error instanceof Error && error.name === 'QuotaExceededError';

/** The state of the journal after a failure of its database. */
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
