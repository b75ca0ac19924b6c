import type { Problem } from '../../schema/index.ts';
import type { Conflict } from './merge.ts';

/** Where the work is, for the person. In all but the first two the journal has what the disk has not. */
export type SaveState =
  | { readonly kind: 'saved' }
  | { readonly kind: 'saving' }
  /** Will be written in a moment. */
  | { readonly kind: 'unsaved' }
  /** Nobody answers; it tries again by itself. */
  | { readonly kind: 'offline'; readonly message: string; readonly hint: string }
  /** The disk does not take it; it tries again by itself. */
  | { readonly kind: 'failing'; readonly message: string; readonly hint: string }
  /** Both the disk and this page have changed the same thing: `resolve` goes on. */
  | { readonly kind: 'conflict'; readonly conflicts: readonly Conflict[] }
  /** Somebody deleted the file: `keepMine` writes it again. */
  | { readonly kind: 'deleted' }
  /** The file is there, and is no level now: it goes on by itself once the file is mended, or `keepMine` writes this one in its place. */
  | { readonly kind: 'unreadable'; readonly problems: readonly Problem[] }
  /** `unsaved`: changes of this page that another took the level from before they were written. */
  | { readonly kind: 'readOnly'; readonly why: string; readonly unsaved: boolean };
