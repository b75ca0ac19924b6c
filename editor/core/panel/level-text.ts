import { useEffect, useEffectEvent, useMemo, useState } from 'react';
import { formatLevel, type Problem } from '../../../schema/index.ts';
import { type Editor, useEditor } from '../context/index.ts';
import { readText, type StorageError } from '../files/index.ts';
import { openListed } from '../levels/index.ts';

const NOTHING = [] as const;

/** A level that is edited as text, beside its version in the editor or on disk. */
export interface LevelText {
  /** null if it is not read yet, or if there is none */
  readonly base: Base | null;
  readonly text: string;
  readonly setText: (text: string) => void;
  readonly isDirty: boolean;
  readonly isValid: boolean;
  /** Problems of the text. */
  readonly problems: readonly Problem[];
  readonly isUnreadable: boolean;
  /** Why it could not be read or saved. */
  readonly error: StorageError | null;
  /** A newer version that arrived while the user was typing. */
  readonly newer: Base | null;
  /** The version that competes with the text, offered to the user; null if there is none. */
  readonly theirs: Base | null;
  /** Replaces the text by a version. */
  readonly take: (base: Base) => void;
  /** @param over etag of the version to overwrite; null: the one that the text is based on */
  readonly save: (over: string | null) => Promise<void>;
}

/**
 * @param fromDisk edits the file on disk, even if the level is open @param onSaved called when the text is saved, or applied to
 * the open level
 */
export function useLevelText(id: string, fromDisk: boolean, onSaved: () => void): LevelText {
  const editor = useEditor();
  const { workspace, open, notices } = editor;
  const [base, setBase] = useState<Base | null>(null);
  const [text, setText] = useState('');
  const [error, setError] = useState<StorageError | null>(null);
  const [newer, setNewer] = useState<Base | null>(null);
  /** Why there is no text; null if there is one. */
  const [unreadable, setUnreadable] = useState<readonly Problem[] | null>(null);
  const isDirty = base !== null && text !== base.text;

  const take = (now: Base) => {
    setBase(now);
    setText(now.text);
    setUnreadable(null);
    setError(null);
    setNewer(null);
  };
  const onSource = useEffectEvent((source: Source) => {
    if (source.kind === 'none') {
      // typed text stays
      if (!isDirty) {
        setBase(null);
        setUnreadable(source.problems);
      }
    } else if (!isDirty || source.base.text === text) take(source.base);
    // the disk is back at the version that the text is based on
    else if (source.base.text === base?.text) {
      setBase(source.base);
      setNewer(null);
    } else setNewer(source.base);
  });
  useEffect(() => followSource(editor, id, fromDisk, onSource, setError), [editor, id, fromDisk]);

  const reading = useMemo(() => (base === null ? null : readText(text)), [base, text]);
  const problems: readonly Problem[] =
    unreadable ??
    (base !== null && !isDirty && base.problems.length > 0 ? base.problems : reading?.ok === false ? reading.problems : NOTHING);

  const save = async (over: string | null) => {
    if (reading?.ok !== true || base === null || !isDirty) return;
    const level = open.getState();
    if (base.etag === null && level?.opened.id() === id) {
      const result = level.document.replace('Edited as text', reading.file);
      if (result.ok) onSaved();
      else notices.refuse(result.refusal);
      return;
    }
    const answer = await workspace.storage.write(id, text, over ?? base.etag);
    if (!answer.ok) {
      setError(answer.error);
      return;
    }
    await workspace.refresh();
    onSaved();
    if (level?.opened.id() === id) level.opened.saver.refresh();
    else await openListed(editor, id);
  };
  const current = error?.code === 'conflict' ? error.current : null;
  const theirs: Base | null =
    newer ?? (current === null ? null : { text: current.text ?? '', etag: current.etag, problems: current.problems });
  const isValid = reading?.ok === true;
  return { base, text, setText, isDirty, isValid, problems, isUnreadable: unreadable !== null, error, newer, theirs, take, save };
}

/** A version of the text. `etag` is null for the open level, which lives in the editor rather than on disk. */
interface Base {
  readonly text: string;
  readonly etag: string | null;
  /** Problems found by the storage, which knows more about some files than their text shows. */
  readonly problems: readonly Problem[];
}

/** The text to edit, or why there is none. */
type Source = { readonly kind: 'text'; readonly base: Base } | { readonly kind: 'none'; readonly problems: readonly Problem[] };

/** Follows the text of a level: in the editor if it is open and not `fromDisk`, else on disk. @returns stops it */
function followSource(
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
