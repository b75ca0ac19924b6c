import { CircleCheck, CircleDashed, CircleHelp, CircleX, FileWarning } from 'lucide-react';
import type { ComponentType } from 'react';
import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import type { LevelEntry } from '../../../schema/index.ts';
import type { LevelFacts } from '../../workers/index.ts';
import type { Editor } from '../context/index.ts';
import { keptWith } from '../kept/index.ts';
import { type Picture, pictureKey, picturesOf } from '../pictures/index.ts';
import { termsKey } from '../terms/index.ts';

const THEMES = ['dark', 'light'] as const;
type Theme = (typeof THEMES)[number];

/** The thumbnails that were made. */
export interface MadeThumbnails {
  /** By `thumbnailKey`. */
  readonly byKey: ReadonlyMap<string, Picture>;
  /** What the levels have for players, by `factsKey`; null for a file that is no valid level. It is small, so all of it is kept. */
  readonly facts: ReadonlyMap<string, LevelFacts | null>;
  /** The key of the last thumbnail of each level. */
  readonly lastKey: ReadonlyMap<LevelEntry['id'], string>;
}

export interface Thumbnails {
  readonly store: StoreApi<MadeThumbnails>;
  /** Requests a thumbnail unless it exists; the latest request is served first. */
  want(entry: LevelEntry, theme: Theme, terms: Terms): void;
  /** Cancels a request whose row is no longer visible, unless it has begun. */
  drop(key: string): void;
}

/** px: twice the shown size, for high-density screens */
const WIDTH = 144;

/** Everything that a thumbnail depends on, as a key; null if the file can't be read. */
export const thumbnailKey = ({ etag }: LevelEntry, theme: Theme, terms: Terms): string | null =>
  etag === null ? null : pictureKey(etag, { terms, theme, width: WIDTH });

/** Everything that the facts of a level depend on, as a key; null if the file can't be read. */
export const factsKey = ({ etag }: Pick<LevelEntry, 'etag'>, terms: Terms): string | null =>
  etag === null ? null : `${etag} ${termsKey(terms)}`;

/** What a level has for players; undefined until it is known, null for a file that is no valid level. */
export const factsOf = ({ facts }: MadeThumbnails, entry: LevelEntry, terms: Terms): LevelFacts | null | undefined =>
  entry.status === 'valid' ? facts.get(factsKey(entry, terms) ?? '') : null;

/** The picture of a level: that of the current file or, until it is made, the previous one; null if there is none. */
export function pictureOf({ byKey, lastKey }: MadeThumbnails, entry: LevelEntry, theme: Theme, terms: Terms): string | null {
  const key = thumbnailKey(entry, theme, terms);
  const made = (key === null ? undefined : byKey.get(key)) ?? byKey.get(lastKey.get(entry.id) ?? '');
  return made?.url ?? null;
}

/** The verdict on the current file, in whichever theme it was drawn; null until it is known. */
export function verdictOf({ byKey }: MadeThumbnails, entry: LevelEntry, terms: Terms): Picture['verdict'] | null {
  for (const theme of THEMES) {
    const made = byKey.get(thumbnailKey(entry, theme, terms) ?? '');
    if (made !== undefined) return made.verdict;
  }
  return null;
}

/** The thumbnails of this page. */
export const thumbnailsOf = keptWith((editor: Editor): Thumbnails => {
  const { storage } = editor.workspace;
  const pictures = picturesOf(editor);
  const store = createStore<MadeThumbnails>(() => ({ ...pictures.store.getState(), facts: new Map(), lastKey: new Map() }));
  pictures.store.subscribe(({ byKey }) => byKey !== store.getState().byKey && store.setState({ byKey }));
  /** The last keys, with that of a level that has a picture now. */
  const withLast = (id: LevelEntry['id'], key: string) => new Map(store.getState().lastKey).set(id, key);
  return {
    store,
    want(entry, theme, terms) {
      const key = thumbnailKey(entry, theme, terms);
      if (key === null) return;
      // it may have been drawn for another file with this content
      if (store.getState().byKey.has(key)) {
        if (store.getState().lastKey.get(entry.id) !== key) store.setState({ lastKey: withLast(entry.id, key) });
        return;
      }
      pictures.want(key, {
        ...{ terms, theme, width: WIDTH },
        async text() {
          const answer = await storage.read(entry.id);
          // a file that has changed in the meantime is requested again under its new key
          return answer.ok && answer.value.etag === entry.etag ? answer.value.text : null;
        },
        onDrawn(found) {
          const facts = new Map(store.getState().facts).set(factsKey(entry, terms) ?? '', found);
          store.setState({ facts, lastKey: withLast(entry.id, key) });
        },
      });
    },
    drop: pictures.drop,
  };
});

/** The verdict of a level in the list, as far as it is known. */
export type ListedVerdict = 'completable' | 'broken' | 'unproven' | 'impossible' | 'invalid' | 'unreadable' | 'unknown';

const SIGNS: Readonly<Record<ListedVerdict, { Icon: ComponentType<{ size: number }>; word: string }>> = {
  completable: { Icon: CircleCheck, word: 'completable' },
  broken: { Icon: CircleX, word: 'broken' },
  unproven: { Icon: CircleHelp, word: 'unproven' },
  impossible: { Icon: CircleX, word: 'impossible' },
  invalid: { Icon: FileWarning, word: 'invalid' },
  unreadable: { Icon: FileWarning, word: 'unreadable' },
  unknown: { Icon: CircleDashed, word: 'checking' },
};

/** A verdict as an icon and a word. */
export function VerdictSign({ verdict }: { verdict: ListedVerdict }) {
  const { Icon, word } = SIGNS[verdict];
  return (
    <span className={`verdict verdict--${verdict}`}>
      <Icon size={12} aria-hidden />
      {word}
    </span>
  );
}
