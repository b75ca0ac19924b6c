import { Flag, Trash2 } from 'lucide-react';
import { Popover } from 'radix-ui';
import { type FormEvent, type KeyboardEvent, memo, useRef, useState } from 'react';
import { LIMITS } from '../../schema/index.ts';
import { useDocument, useEditor, useLevel } from '../core/context/index.ts';
import { addNote, deleteNote, moveNote, notesOf, type Recipe, rewordNote } from '../core/document/index.ts';
import { Button } from '../core/ui/index.ts';
import { type Scale, toX } from './scale.ts';

/** A note that is being written. */
export interface WrittenNote {
  readonly tick: number;
  /** Its place among the notes of the run; null: it is new. */
  readonly index: number | null;
}

interface NoteFlagsProps {
  readonly run: string;
  readonly scale: Scale;
  readonly width: number;
  readonly written: WrittenNote | null;
  readonly onWrite: (note: WrittenNote | null) => void;
}

const place = (tick: number): string => `tick ${tick}, ${(tick / 60).toFixed(2)} s`;

/** The notes of the run as flags on the ruler. A flag opens the note; arrow keys move it, Delete removes it. */
export const NoteFlags = memo(function NoteFlags({ run, scale, width, written, onWrite }: NoteFlagsProps) {
  const { session, notices } = useEditor();
  const { document } = useLevel();
  // the file's own list, which is the same object until it changes
  useDocument(({ file }) => file.runs?.find(({ name }) => name === run)?.notes);
  const notes = notesOf(document.file(), run);
  const change = (label: string, recipe: Recipe, gesture?: string) => {
    const result = document.change(label, recipe, gesture === undefined ? {} : { gesture });
    if (!result.ok) notices.refuse(result.refusal);
  };
  const onKey = (event: KeyboardEvent, index: number) => {
    const { tick, text } = notes[index];
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by !== undefined) {
      const to = Math.min(LIMITS.tick, Math.max(0, tick + by * (event.shiftKey ? 10 : 1)));
      change('Move note', moveNote(run, index, to), `note ${run} ${text}`);
    } else if (event.key === 'Delete' || event.key === 'Backspace') change('Delete note', deleteNote(run, index));
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const x = written === null ? 0 : toX(scale, written.tick);
  return (
    <>
      <ul className="flags" aria-label={`Notes of the run ${run}`}>
        {notes.map(({ tick, text }, index) => {
          const left = toX(scale, tick);
          if (left < 0 || left > width) return null;
          return (
            // notes have no ids, and two may say the same
            // biome-ignore lint/suspicious/noArrayIndexKey: see above
            <li key={index} className="flags__one" style={{ left }}>
              <button
                type="button"
                className="flags__flag"
                title={`${place(tick)}: ${text}`}
                aria-label={`Note at ${place(tick)}: ${text}`}
                onPointerDown={(event) => event.stopPropagation()}
                onClick={() => {
                  session.setState({ tick, isPlayingBack: false, hoverTick: null });
                  onWrite({ tick, index });
                }}
                onKeyDown={(event) => onKey(event, index)}
              >
                <Flag size={12} aria-hidden />
              </button>
            </li>
          );
        })}
      </ul>
      <Popover.Root open={written !== null} onOpenChange={(isOpen) => !isOpen && onWrite(null)}>
        <Popover.Anchor className="flags__anchor" style={{ left: Math.min(width, Math.max(0, x)) }} />
        <Popover.Portal>
          <Popover.Content
            className="note"
            side="top"
            sideOffset={6}
            collisionPadding={8}
            aria-label={written === null ? 'Note' : `Note at ${place(written.tick)}`}
          >
            {written !== null && (
              <NoteForm
                // another note, another text
                key={`${written.index} ${written.tick}`}
                note={written}
                text={written.index === null ? '' : (notes[written.index]?.text ?? '')}
                onDone={(text) => {
                  onWrite(null);
                  const { index, tick } = written;
                  if (index === null && text.trim() !== '') change('Add note', addNote(run, tick, text));
                  else if (index !== null && text !== notes[index]?.text) change('Edit note', rewordNote(run, index, text));
                }}
                onDelete={() => {
                  onWrite(null);
                  if (written.index !== null) change('Delete note', deleteNote(run, written.index));
                }}
              />
            )}
          </Popover.Content>
        </Popover.Portal>
      </Popover.Root>
    </>
  );
});

interface NoteFormProps {
  readonly note: WrittenNote;
  readonly text: string;
  readonly onDone: (text: string) => void;
  readonly onDelete: () => void;
}

/** A field for the text of a note. What is typed is kept when the field is left; Esc drops it. */
function NoteForm({ note, text, onDone, onDelete }: NoteFormProps) {
  const [typed, setTyped] = useState(text);
  const isDropped = useRef(false);
  const isOver = useRef(false);
  const end = (act: () => void) => {
    if (isOver.current) return;
    isOver.current = true;
    act();
  };
  const onSubmit = (event: FormEvent) => {
    event.preventDefault();
    end(() => onDone(typed));
  };
  return (
    <form className="note__form" onSubmit={onSubmit}>
      <label className="note__label" htmlFor="note-text">
        Note at {place(note.tick)}
      </label>
      <div className="note__line">
        <input
          id="note-text"
          type="text"
          className="field"
          value={typed}
          maxLength={LIMITS.note}
          placeholder="what happens here"
          autoComplete="off"
          onChange={(event) => setTyped(event.target.value)}
          onKeyDown={(event) => {
            if (event.key === 'Escape') isDropped.current = true;
          }}
          onBlur={({ relatedTarget, currentTarget }) => {
            if (isDropped.current || currentTarget.form?.contains(relatedTarget) === true) return;
            end(() => onDone(typed));
          }}
        />
        {note.index !== null && (
          <Button hint="Delete the note" icon={<Trash2 size={14} />} type="button" onClick={() => end(onDelete)} />
        )}
      </div>
    </form>
  );
}
