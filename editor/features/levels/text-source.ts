import { formatLevel, type Problem } from '../../../schema/index.ts';
import type { Editor } from '../../core/context/index.ts';
import type { StorageError } from '../../core/files/index.ts';

/** A version of the text. `etag` is null for the open level, which lives in the editor rather than on disk. */
export interface Base {
  readonly text: string;
  readonly etag: string | null;
  /** Problems found by the storage, which knows more about some files than their text shows. */
  readonly problems: readonly Problem[];
}

/** The text to edit, or why there is none. */
export type Source =
  | { readonly kind: 'text'; readonly base: Base }
  | { readonly kind: 'none'; readonly problems: readonly Problem[] };

/** Follows the text of a level: in the editor if it is open and not `fromDisk`, else on disk. @returns stops it */
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
      onSource({ kind: 'text', base: { text: formatLevel(document.committedFile()), etag: null, problems: [] } });
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
