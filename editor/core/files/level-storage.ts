import type {
  DeleteResponse,
  EditErrorCode,
  EditEvent,
  ErrorResponse,
  LevelEntry,
  ListResponse,
  OrderResponse,
  PackOnDisk,
  PublishRequest,
  PublishResponse,
  ReadResponse,
  RefusedLevel,
  TrashEntry,
} from '../../../schema/index.ts';

/** Why a request failed. `unreachable`: no answer; `unexpected`: an answer that was not understood. */
export interface StorageError {
  readonly code: EditErrorCode | 'unreachable' | 'unexpected';
  readonly message: string;
  readonly hint: string;
  readonly problems: NonNullable<ErrorResponse['error']['problems']>;
  /** `conflict`: the current state instead of the base; null: the level no longer exists. */
  readonly current: ReadResponse | null;
  /** `not-completable`: the levels that are not published as they are. */
  readonly levels?: readonly RefusedLevel[];
  /** `not-published`: files that must be corrected first. */
  readonly files?: ErrorResponse['error']['files'];
}

export type Answer<T> = { readonly ok: true; readonly value: T } | { readonly ok: false; readonly error: StorageError };

/** Whether a storage can be reached. `otherRun`: the server was restarted and does not know this page. */
export type Link = 'up' | 'gone' | 'otherRun';

/** What is to be published, and where. */
export type Publishing = Omit<PublishRequest, 'client'>;

/** Where levels are stored: in a folder behind `gq edit`, or in this browser. Its promises never reject. */
export interface LevelStorage {
  readonly kind: 'server' | 'browser';
  /** Whether the data outlives the page. */
  readonly lasts: boolean;
  list(): Promise<Answer<ListResponse>>;
  read(id: string): Promise<Answer<ReadResponse>>;
  /** @param base etag of the version that the text is based on; null for a new level */
  write(id: string, text: string, base: string | null): Promise<Answer<LevelEntry>>;
  rename(id: string, to: string, base: string): Promise<Answer<LevelEntry>>;
  duplicate(id: string, to: string, base: string): Promise<Answer<LevelEntry>>;
  remove(id: string, base: string): Promise<Answer<DeleteResponse>>;
  trash(): Promise<Answer<readonly TrashEntry[]>>;
  restore(trash: string, to?: string): Promise<Answer<LevelEntry>>;
  order(folder: string, ids: readonly string[]): Promise<Answer<OrderResponse>>;
  /**
   * Writes the `pack.json` of the folder, or removes it (`text` null).
   * @param base etag of the version that the text is based on; null: there is no such file
   * @returns the file as it is now; null: there is none
   */
  writePack(text: string | null, base: string | null): Promise<Answer<PackOnDisk | null>>;
  /** Makes a page of levels in a folder beside them; null where there are no folders. */
  readonly publish: ((wanted: Publishing) => Promise<Answer<PublishResponse>>) | null;
  /**
   * Reports changes of levels by anyone but this page.
   * @param onLink called when the link changes
   * @returns stops it
   */
  watch(onEvent: (event: EditEvent) => void, onLink: (link: Link) => void): () => void;
}

/** An error, with defaults for the fields that only some errors have. */
export const storageError = (
  code: StorageError['code'],
  message: string,
  hint: string,
  more: Partial<Pick<StorageError, 'problems' | 'current' | 'levels'>> = {},
): StorageError => ({ code, message, hint, problems: [], current: null, ...more });

/** What went wrong and what to do, as sentences. */
export function errorInWords({ message, hint }: StorageError): string {
  const sentence = (text: string) => `${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.?!]$/.test(text) ? '' : '.'}`;
  return `${sentence(message)} ${sentence(hint)}`;
}
