import { CircleCheck, TriangleAlert } from 'lucide-react';
import { type Ref, useImperativeHandle, useRef, useState } from 'react';
import type { Problem } from '../../../schema/index.ts';
import { isModKey } from '../commands/index.ts';
import { errorInWords } from '../files/index.ts';
import { Button, Dialog } from '../ui/index.ts';
import { type LevelText, useLevelText } from './level-text.ts';
import './text-dialog.css';

export interface TextDialogProps {
  readonly id: string;
  /** Edits the file on disk, even if the level is open. */
  readonly fromDisk?: boolean;
  readonly onClose: () => void;
}

/** Edits a level as text, above all an invalid one. Only a valid level replaces the file on disk. */
export function TextDialog({ id, fromDisk = false, onClose }: TextDialogProps) {
  const level = useLevelText(id, fromDisk, onClose);
  const { base, text, setText, isDirty, problems, isUnreadable, error, newer, save } = level;
  const [isLeaving, setIsLeaving] = useState(false);
  const area = useRef<TextAreaHandle>(null);
  const where = base?.etag === null ? 'in the editor' : 'on disk';
  const leave = () => (isDirty && !isLeaving ? setIsLeaving(true) : onClose());

  return (
    <Dialog open wide title={`${id}.level.json`} about="The level as text. It can only be saved if it is valid." onClose={leave}>
      {base === null && error === null && !isUnreadable && <p>Reading…</p>}
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
      {(base !== null || isUnreadable) && (
        <TextProblems problems={problems} onGoTo={(line, column) => area.current?.goTo(line, column)} />
      )}
      <TextRefusal level={level} where={where} />
      <div className="form__buttons">
        {isLeaving && <span className="astext__leaving">Your changes are not saved.</span>}
        <Button hint={isLeaving ? 'Discard your changes' : 'Close'} look={isLeaving ? 'danger' : 'outlined'} onClick={leave}>
          {isLeaving ? 'Discard' : 'Close'}
        </Button>
        <Button
          hint={problems.length > 0 ? 'Fix the listed problems first' : newer !== null ? 'Choose a version first' : 'Save'}
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

interface TextAreaHandle {
  /** Line and column count from 1. */
  goTo(line: number, column: number): void;
}

interface TextAreaProps {
  readonly ref: Ref<TextAreaHandle>;
  readonly label: string;
  readonly text: string;
  readonly problems: readonly Problem[];
  readonly onChange: (text: string) => void;
  readonly onSave: () => void;
}

/** px; repeated in the style sheet */
const LINE = 18;

/** A text area with line numbers; lines with a problem are marked. */
function TextArea({ ref, label, text, problems, onChange, onSave }: TextAreaProps) {
  const field = useRef<HTMLTextAreaElement>(null);
  const numbers = useRef<HTMLDivElement>(null);
  const marked = new Set(problems.map(({ line }) => line));
  const lines = text.split('\n').length;
  useImperativeHandle(ref, () => ({
    goTo(line, column) {
      const element = field.current;
      if (element === null) return;
      const before = element.value.split('\n').slice(0, line - 1);
      const at = before.reduce((sum, one) => sum + one.length + 1, 0) + column - 1;
      element.focus();
      element.setSelectionRange(at, at);
      element.scrollTop = Math.max(0, (line - 6) * LINE);
    },
  }));
  return (
    <div className="astext">
      <div ref={numbers} className="astext__numbers" aria-hidden>
        {Array.from({ length: lines }, (_, i) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a line is known by its number alone
          <div key={i} className={marked.has(i + 1) ? 'astext__number astext__number--bad' : 'astext__number'}>
            {i + 1}
          </div>
        ))}
      </div>
      <textarea
        ref={field}
        className="astext__text"
        aria-label={label}
        aria-invalid={problems.length > 0}
        value={text}
        wrap="off"
        spellCheck={false}
        autoCapitalize="off"
        onChange={(event) => onChange(event.target.value)}
        onScroll={(event) => {
          if (numbers.current !== null) numbers.current.scrollTop = event.currentTarget.scrollTop;
        }}
        onKeyDown={(event) => {
          if (!isModKey(event, 's')) return;
          event.preventDefault();
          onSave();
        }}
      />
    </div>
  );
}

interface TextProblemsProps {
  readonly problems: readonly Problem[];
  /** Moves to a place in the text. */
  readonly onGoTo: (line: number, column: number) => void;
}

/** The problems of a level's text, or that it is valid. */
function TextProblems({ problems, onGoTo }: TextProblemsProps) {
  if (problems.length === 0) {
    return (
      <p className="astext__fine">
        <CircleCheck size={14} aria-hidden /> A valid level.
      </p>
    );
  }
  return (
    <ul className="astext__problems" aria-label="Problems">
      {problems.map(({ code, pointer, line, column, message, hint }) => (
        <li key={`${code} ${pointer} ${line} ${column}`}>
          <button type="button" className="astext__problem" onClick={() => onGoTo(line ?? 1, column ?? 1)}>
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
  );
}

interface TextRefusalProps {
  readonly level: LevelText;
  /** Where the other version is: in the editor, on disk. */
  readonly where: string;
}

/** Why a text could not be saved, and the choices if the level has changed in the meantime. */
function TextRefusal({ level, where }: TextRefusalProps) {
  const { error, newer, theirs, isValid, take, save } = level;
  if (error === null && theirs === null) return null;
  return (
    <div className="astext__refusal" role="alert">
      <p>
        {error !== null && newer === null
          ? errorInWords(error)
          : `The level was changed ${where} in the meantime. Your text is kept; it is based on the previous version.`}
      </p>
      {theirs !== null && (
        <>
          <Button hint="Discard your text" look="outlined" onClick={() => take(theirs)}>
            Use the version {where}
          </Button>
          <Button hint={`Replace the version ${where}`} look="danger" disabled={!isValid} onClick={() => void save(theirs.etag)}>
            Overwrite
          </Button>
        </>
      )}
    </div>
  );
}
