import { CircleCheck, TriangleAlert } from 'lucide-react';
import { useEffect, useMemo, useRef, useState } from 'react';
import { formatLevel, type Problem } from '../../../schema/index.ts';
import { useEditor } from '../../context/index.ts';
import { readText, type StorageError } from '../../files/index.ts';
import { Button, Dialog } from '../../ui/index.ts';
import { openListed } from './level-files.ts';
import { TextArea, type TextAreaHandle } from './TextArea.tsx';

/** A text and what it is based on. `etag` is null for the open level, which is changed in the editor rather than on the disk. */
interface Base {
  readonly text: string;
  readonly etag: string | null;
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
  /** Why there is no text to show; null: there is one. */
  const [unreadable, setUnreadable] = useState<readonly Problem[] | null>(null);
  const [isLeaving, setIsLeaving] = useState(false);
  const area = useRef<TextAreaHandle>(null);

  useEffect(() => {
    let isGone = false;
    const show = (now: Base) => {
      setBase(now);
      setText(now.text);
    };
    const level = open.getState();
    if (!fromDisk && level?.opened.id() === id) {
      show({ text: formatLevel(level.document.file()), etag: null });
      return;
    }
    void workspace.storage.read(id).then((answer) => {
      if (isGone) return;
      if (!answer.ok) setError(answer.error);
      else if (answer.value.text === null) setUnreadable(answer.value.problems);
      else show({ text: answer.value.text, etag: answer.value.etag });
    });
    return () => {
      isGone = true;
    };
  }, [id, fromDisk, open, workspace]);

  const reading = useMemo(() => (base === null ? null : readText(text)), [base, text]);
  const problems: readonly Problem[] = unreadable ?? (reading?.ok === false ? reading.problems : []);
  const isDirty = base !== null && text !== base.text;

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
  const theirs = error?.code === 'conflict' ? error.current : null;
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
                    {message} <span className="astext__hint">{hint}</span>
                  </span>
                </button>
              </li>
            ))}
          </ul>
        ))}
      {error !== null && (
        <div className="astext__refusal" role="alert">
          <p>
            {error.message}. {error.hint}.
          </p>
          {theirs !== null && (
            <>
              <Button
                hint="Drop what was typed here"
                look="outlined"
                onClick={() => {
                  setBase({ text: theirs.text ?? '', etag: theirs.etag });
                  setText(theirs.text ?? '');
                  setError(null);
                }}
              >
                Take what is on the disk
              </Button>
              <Button
                hint="Replace what is on the disk"
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
          hint={problems.length > 0 ? 'Mend what is listed first' : 'Save'}
          shortcut="Ctrl S"
          look="main"
          disabled={!isDirty || problems.length > 0 || base === null}
          onClick={() => void save(null)}
        >
          {base?.etag === null ? 'Apply' : 'Save and open'}
        </Button>
      </div>
    </Dialog>
  );
}
