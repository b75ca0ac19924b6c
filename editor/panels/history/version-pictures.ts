import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import { oneAtATime } from '../../ask/index.ts';
import type { Editor, OpenLevel } from '../../context/index.ts';
import { keptWith } from '../../kept/index.ts';
import { termsKey } from '../../terms/index.ts';
import type { LevelVersions, Version } from '../../versions/index.ts';
import { jobs, type Results, type Workers } from '../../workers/index.ts';

/** How a version is drawn and judged. */
export interface DrawnBy {
  readonly theme: 'dark' | 'light';
  readonly terms: Terms;
}

interface Wanted {
  readonly version: Version;
  readonly by: DrawnBy;
}

interface VersionPicture {
  /** A data URL; null if it can't be drawn. */
  readonly url: string | null;
  readonly verdict: Results['thumbnail']['verdict'];
}

/** Small pictures of versions, made while their rows are visible. */
export interface VersionPictures {
  /** By `pictureKey`. */
  readonly store: StoreApi<ReadonlyMap<string, VersionPicture>>;
  /** Asks for a picture unless there is one; the latest request is served first. */
  want(version: Version, by: DrawnBy): void;
  /** Withdraws a request that is not served yet. */
  drop(key: string): void;
}

/** px: twice the shown size, for high-density screens */
const WIDTH = 128;
/** number of pictures kept, some 30 kB each */
const KEPT = 300;

/** Versions with the same text look alike. */
export const pictureKey = ({ check }: Version, { theme, terms }: DrawnBy): string => `${check} ${theme} ${termsKey(terms)}`;

function createPictures(workers: Workers, versions: LevelVersions): VersionPictures {
  const store = createStore<ReadonlyMap<string, VersionPicture>>(() => new Map());
  const make = async (key: string, { version, by: { theme, terms } }: Wanted) => {
    const text = await versions.text(version);
    if (text === null) return;
    const end = await workers.start(jobs.thumbnail, { text, terms, width: WIDTH, theme }).end;
    if (end.kind !== 'done') return;
    const { svg, verdict } = end.result;
    const url = svg === '' ? null : `data:image/svg+xml,${encodeURIComponent(svg)}`;
    const all = [...store.getState(), [key, { url, verdict }] as const];
    store.setState(new Map(all.slice(-KEPT)), true);
  };
  const queue = oneAtATime(make);
  return {
    store,
    want(version, by) {
      const key = pictureKey(version, by);
      if (store.getState().has(key) || queue.has(key)) return;
      queue.want(key, { version, by });
    },
    drop: queue.drop,
  };
}

const picturesWith = keptWith((editor: Editor) =>
  keptWith((level: OpenLevel) => createPictures(editor.workers, level.opened.versions)),
);

/** The pictures of the versions of an open level. */
export const picturesOf = (editor: Editor, level: OpenLevel): VersionPictures => picturesWith(editor)(level);
