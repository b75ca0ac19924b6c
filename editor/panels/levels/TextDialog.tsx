import { CircleCheck, TriangleAlert } from 'lucide-react';
import { useEffect, useEffectEvent, useMemo, useRef, useState } from 'react';
import { formatLevel, type Problem } from '../../../schema/index.ts';
import { type Editor, useEditor } from '../../context/index.ts';
import { inPageWords } from '../../document/index.ts';
import { readText, type StorageError } from '../../files/index.ts';
import { Button, Dialog } from '../../ui/index.ts';
import { openListed } from './level-files.ts';
import { TextArea, type TextAreaHandle } from './TextArea.tsx';

/** A text and what it is based on. `etag` is null for the open level, which is changed in the editor rather than on the disk. */
interface Base {
  readonly text: string;
  readonly etag: string | null;
  /** What the storage finds wrong with it: of some files it knows more than their text tells. */
  readonly problems: readonly Problem[];
}

/** What there is to edit: a text, or why there is none. */
type Source = { readonly kind: 'text'; readonly base: Base } | { readonly kind: 'none'; readonly problems: readonly Problem[] };

const NOTHING = [] as const;

/** Follows what a level says: in the editor where it is open and not `fromDisk`, else on the disk. @returns stops it */
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
    const tell = () =>
      onSource({ kind: 'text', base: { text: formatLevel(document.settledFile()), etag: null, problems: NOTHING } });
    tell();
    return document.onStep(tell);
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

interface TextDialogProps {
  readonly id: string;
  /** What is on the disk, even of the open level. */
  readonly fromDisk?: boolean;
  readonly onClose: () => void;
}

/** Edits a level as text: one that is not valid, so that it can be mended, or any other. What is on the disk is replaced only by a valid level. */
export function TextDialog({ id, fromDisk = false, onClose }: TextDialogProps) {
  const editor = useEditor();
  const { workspace, open, notices } = editor;
  const [base, setBase] = useState<Base | null>(null);
  const [text, setText] = useState('');
  const [error, setError] = useState<StorageError | null>(null);
  /** What has come in place of the base while something was typed. */
  const [newer, setNewer] = useState<Base | null>(null);
  /** Why there is no text to show; null: there is one. */
  const [unreadable, setUnreadable] = useState<readonly Problem[] | null>(null);
  const [isLeaving, setIsLeaving] = useState(false);
  const area = useRef<TextAreaHandle>(null);
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
      // what is being typed stays
      if (!isDirty) {
        setBase(null);
        setUnreadable(source.problems);
      }
    } else if (!isDirty || source.base.text === text) take(source.base);
    // it went back to what is being changed here
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
      if (result.ok) onClose();
      else notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`, { topic: 'refused' });
      return;
    }
    const answer = await workspace.storage.write(id, text, over ?? base.etag);
    if (!answer.ok) {
      setError(answer.error);
      return;
    }
    await editor.workspace.refresh();
    onClose();
    if (level?.opened.id() === id) level.opened.saver.refresh();
    else await openListed(editor, id);
  };
  const current = error?.code === 'conflict' ? error.current : null;
  const theirs: Base | null =
    newer ?? (current === null ? null : { text: current.text ?? '', etag: current.etag, problems: current.problems });
  const where = base?.etag === null ? 'in the editor' : 'on the disk';
  const leave = () => (isDirty && !isLeaving ? setIsLeaving(true) : onClose());

  return (
    <Dialog open wide title={`${id}.level.json`} about="The level as text. It is saved only as a valid level." onClose={leave}>
      {base === null && error === null && unreadable === null && <p>Reading…</p>}
      {base !== null && (
        <TextArea
          ref={area}
          label="Text of the level"
          text={text}
          problems={problems}
          onChange={setText}
          onSave={() => void save(null)}
        />
      )}
      {(base !== null || unreadable !== null) &&
        (problems.length === 0 ? (
          <p className="astext__fine">
            <CircleCheck size={14} aria-hidden /> A valid level.
          </p>
        ) : (
          <ul className="astext__problems" aria-label="Problems">
            {problems.map(({ code, pointer, line, column, message, hint }) => (
              <li key={`${code} ${pointer} ${line} ${column}`}>
                <button type="button" className="astext__problem" onClick={() => area.current?.goTo(line ?? 1, column ?? 1)}>
                  <TriangleAlert size={13} aria-hidden />
                  {line !== null && (
                    <span className="astext__place">
                      {line}:{column}
                    </span>
                  )}
                  <span>
                    {inPageWords(message)} <span className="astext__hint">{inPageWords(hint)}</span>
                  </span>
                </button>
              </li>
            ))}
          </ul>
        ))}
      {(error !== null || theirs !== null) && (
        <div className="astext__refusal" role="alert">
          <p>
            {error !== null && newer === null
              ? `${error.message}. ${error.hint}.`
              : `The level was changed ${where} meanwhile. What was typed here is kept, and rests on what was there before.`}
          </p>
          {theirs !== null && (
            <>
              <Button hint="Drop what was typed here" look="outlined" onClick={() => take(theirs)}>
                Take what is {where}
              </Button>
              <Button
                hint={`Replace what is ${where}`}
                look="danger"
                disabled={reading?.ok !== true}
                onClick={() => void save(theirs.etag)}
              >
                Save over it
              </Button>
            </>
          )}
        </div>
      )}
      <div className="form__buttons">
        {isLeaving && <span className="astext__leaving">What was typed is not saved.</span>}
        <Button hint={isLeaving ? 'Drop what was typed' : 'Close'} look={isLeaving ? 'danger' : 'outlined'} onClick={leave}>
          {isLeaving ? 'Drop it' : 'Close'}
        </Button>
        <Button
          hint={problems.length > 0 ? 'Mend what is listed first' : newer !== null ? 'Choose above first' : 'Save'}
          shortcut="Ctrl S"
          look="main"
          disabled={!isDirty || problems.length > 0 || base === null || newer !== null}
          onClick={() => void save(null)}
        >
          {base?.etag === null ? 'Apply' : 'Save and open'}
        </Button>
      </div>
    </Dialog>
  );
}
