import type { Conflict } from '../../../review/index.ts';
import type { Problem } from '../../../schema/index.ts';

/** Where the work is stored, as the user sees it. In all states but the first two, the journal has what the disk lacks. */
export type SaveState =
  | { readonly kind: 'saved' }
  | { readonly kind: 'saving' }
  /** will be written in a moment */
  | { readonly kind: 'unsaved' }
  /** no answer; retried automatically */
  | { readonly kind: 'offline'; readonly message: string; readonly hint: string }
  /** the disk does not accept it; retried automatically */
  | { readonly kind: 'failing'; readonly message: string; readonly hint: string }
  /** both the disk and this page changed the same thing: `resolve` continues */
  | { readonly kind: 'conflict'; readonly conflicts: readonly Conflict[] }
  /** the file was deleted: `keepMine` writes it again */
  | { readonly kind: 'deleted' }
  /** the file is no longer a valid level: continues once the file is fixed, or `keepMine` overwrites it */
  | { readonly kind: 'unreadable'; readonly problems: readonly Problem[] }
  /** `unsaved`: changes of this page that were not written before another page took the level */
  | { readonly kind: 'readOnly'; readonly why: string; readonly unsaved: boolean };
