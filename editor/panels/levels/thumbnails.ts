import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import type { LevelEntry } from '../../../schema/index.ts';
import { oneAtATime } from '../../ask/index.ts';
import type { Editor } from '../../context/index.ts';
import { keptWith } from '../../kept/index.ts';
import { termsKey } from '../../terms/index.ts';
import { jobs, type LevelFacts, type Results } from '../../workers/index.ts';

const THEMES = ['dark', 'light'] as const;
type Theme = (typeof THEMES)[number];
type Verdict = Results['thumbnail']['verdict'];

/** The picture and the verdict of one state of a level's file. */
interface Thumbnail {
  /** URL of an SVG; null if the level can't be drawn. */
  readonly url: string | null;
  readonly verdict: Verdict;
}

/** The thumbnails that were made. */
export interface MadeThumbnails {
  /** By `thumbnailKey`. */
  readonly byKey: ReadonlyMap<string, Thumbnail>;
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
/** number of pictures kept, some 30 kB each */
const KEPT = 600;

/** Everything that a thumbnail depends on, as a key; null if the file can't be read. */
export const thumbnailKey = ({ etag }: LevelEntry, theme: Theme, terms: Terms): string | null =>
  etag === null ? null : `${etag} ${theme} ${termsKey(terms)}`;

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
export function verdictOf({ byKey }: MadeThumbnails, entry: LevelEntry, terms: Terms): Verdict | null {
  for (const theme of THEMES) {
    const made = byKey.get(thumbnailKey(entry, theme, terms) ?? '');
    if (made !== undefined) return made.verdict;
  }
  return null;
}

/** A requested thumbnail. */
interface Wanted {
  readonly id: string;
  readonly theme: Theme;
  readonly terms: Terms;
}

/** The thumbnails of this page. They are made one at a time, so that other work does not have to wait for the workers. */
export const thumbnailsOf = keptWith(createThumbnails);

function createThumbnails({ workspace, workers }: Editor): Thumbnails {
  const store = createStore<MadeThumbnails>(() => ({ byKey: new Map(), facts: new Map(), lastKey: new Map() }));

  const keep = (key: string, { id, terms }: Wanted, thumbnail: Thumbnail, found: LevelFacts | null) => {
    const { byKey, facts, lastKey } = store.getState();
    const [etag] = key.split(' ');
    const all = new Map(byKey).set(key, thumbnail);
    for (const [old, { url }] of all) {
      if (all.size <= KEPT) break;
      all.delete(old);
      if (url !== null) URL.revokeObjectURL(url);
    }
    const known = new Map(facts).set(factsKey({ etag }, terms) ?? '', found);
    store.setState({ byKey: all, facts: known, lastKey: new Map(lastKey).set(id, key) });
  };
  const make = async (key: string, wanted: Wanted) => {
    const { id, theme, terms } = wanted;
    const answer = await workspace.storage.read(id);
    // a file that has changed in the meantime is requested again under its new key
    if (!answer.ok || answer.value.text === null || !key.startsWith(`${answer.value.etag} `)) return;
    const end = await workers.start(jobs.thumbnail, { text: answer.value.text, terms, width: WIDTH, theme }).end;
    if (end.kind === 'gaveUp') keep(key, wanted, { url: null, verdict: 'unproven' }, null);
    if (end.kind !== 'done') return;
    const { svg, verdict, facts } = end.result;
    const url = svg === '' ? null : URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    keep(key, wanted, { url, verdict }, facts);
  };
  const queue = oneAtATime(make);

  return {
    store,
    want(entry, theme, terms) {
      const key = thumbnailKey(entry, theme, terms);
      if (key === null || store.getState().byKey.has(key) || queue.has(key)) return;
      queue.want(key, { id: entry.id, theme, terms });
    },
    drop: queue.drop,
  };
}
