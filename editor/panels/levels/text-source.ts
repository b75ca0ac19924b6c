import { formatLevel, type Problem } from '../../../schema/index.ts';
import type { Editor } from '../../context/index.ts';
import type { StorageError } from '../../files/index.ts';

/** A text and what it is based on. `etag` is null for the open level, which is changed in the editor rather than on the disk. */
export interface Base {
  readonly text: string;
  readonly etag: string | null;
  /** What the storage finds wrong with it: of some files it knows more than their text tells. */
  readonly problems: readonly Problem[];
}

/** What there is to edit: a text, or why there is none. */
export type Source =
  | { readonly kind: 'text'; readonly base: Base }
  | { readonly kind: 'none'; readonly problems: readonly Problem[] };

/** Follows what a level says: in the editor where it is open and not `fromDisk`, else on the disk. @returns stops it */
export function followSource(
  { workspace, open }: Editor,
  id: string,
  fromDisk: boolean,
  onSource: (source: Source) => void,
  onError: (error: StorageError) => void,
): () => void {
  const level = open.getState();
  if (!fromDisk && level?.opened.id() === id) {
    const { document } = level;
    const report = () =>
      onSource({ kind: 'text', base: { text: formatLevel(document.settledFile()), etag: null, problems: [] } });
    report();
    return document.onStep(report);
  }
  let isGone = false;
  let last = 0;
  const read = async () => {
    const mine = ++last;
    const answer = await workspace.storage.read(id);
    if (isGone || mine !== last) return;
    if (!answer.ok) {
      onError(answer.error);
      return;
    }
    const { text, etag, problems } = answer.value;
    onSource(text === null ? { kind: 'none', problems } : { kind: 'text', base: { text, etag, problems } });
  };
  const entryOf = ({ list }: ReturnType<typeof workspace.store.getState>) => list?.levels.find((entry) => entry.id === id);
  void read();
  const stop = workspace.store.subscribe((now, before) => {
    const [entry, old] = [entryOf(now), entryOf(before)];
    if (entry !== undefined && (entry.etag !== old?.etag || entry.status !== old?.status)) void read();
  });
  return () => {
    isGone = true;
    stop();
  };
}
