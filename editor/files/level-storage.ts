import type {
  DeleteResponse,
  EditErrorCode,
  EditEvent,
  ErrorResponse,
  LevelEntry,
  ListResponse,
  OrderResponse,
  ReadResponse,
  TrashEntry,
} from '../../schema/index.ts';

/** Why something was not done. `unreachable`: nobody answers; `unexpected`: an answer that makes no sense. */
export interface StorageError {
  readonly code: EditErrorCode | 'unreachable' | 'unexpected';
  readonly message: string;
  readonly hint: string;
  readonly problems: NonNullable<ErrorResponse['error']['problems']>;
  /** `conflict`: what is there instead of the base; null: there is no such level any more. */
  readonly current: ReadResponse | null;
}

export type Answer<T> = { readonly ok: true; readonly value: T } | { readonly ok: false; readonly error: StorageError };

/** Whether a storage can be reached. `otherRun`: a server answers that knows nothing of this page, since it was started again. */
export type Link = 'up' | 'gone' | 'otherRun';

/** Where levels are: a folder behind `gq edit`, or this browser. No promise of it ever rejects. */
export interface LevelStorage {
  readonly kind: 'server' | 'browser';
  /** Whether what is written is still there when the page is gone. */
  readonly lasts: boolean;
  list(): Promise<Answer<ListResponse>>;
  read(id: string): Promise<Answer<ReadResponse>>;
  /** @param base etag of what the text came from; null for a new level */
  write(id: string, text: string, base: string | null): Promise<Answer<LevelEntry>>;
  rename(id: string, to: string, base: string): Promise<Answer<LevelEntry>>;
  duplicate(id: string, to: string, base: string): Promise<Answer<LevelEntry>>;
  remove(id: string, base: string): Promise<Answer<DeleteResponse>>;
  trash(): Promise<Answer<readonly TrashEntry[]>>;
  restore(trash: string, to?: string): Promise<Answer<LevelEntry>>;
  order(folder: string, ids: readonly string[]): Promise<Answer<OrderResponse>>;
  /**
   * Tells what happens to levels, done by whomever, but not what this page did itself.
   * @param onLink when that changes
   * @returns stops it
   */
  watch(onEvent: (event: EditEvent) => void, onLink: (link: Link) => void): () => void;
}

/** An error without what only some have. */
export const storageError = (
  code: StorageError['code'],
  message: string,
  hint: string,
  more: Partial<Pick<StorageError, 'problems' | 'current'>> = {},
): StorageError => ({ code, message, hint, problems: [], current: null, ...more });

/** What went wrong and what to do, as sentences. */
export function errorInWords({ message, hint }: StorageError): string {
  const sentence = (text: string) => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
  return `${sentence(message)} ${sentence(hint)}`;
}
