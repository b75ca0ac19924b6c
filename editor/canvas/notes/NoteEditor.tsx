import { useEffect, useRef, useState } from 'react';
import { useEditor, useLevel } from '../../core/context/index.ts';
import {
  editPinnedNote,
  LONGEST_PINNED_NOTE,
  type PinnedNote,
  pinNote,
  pinProblem,
  unpinNote,
} from '../../core/document/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Point, View } from '../view.ts';

interface NoteEditorProps {
  /** null: a new one */
  readonly note: PinnedNote | null;
  /** px of the level */
  readonly place: Point;
  /** px of screen from the canvas's top left */
  readonly at: Point;
  readonly view: View;
  readonly onClose: () => void;
}

/** px of the editor, which stays within the canvas where there is room */
const SIZE = { width: 240, height: 150 } as const;

/** Edits the text of a note. Leaving it keeps what was typed, Esc does not; a note without text is deleted. */
export function NoteEditor({ note, place, at, view, onClose }: NoteEditorProps) {
  const { notices } = useEditor();
  const { document: edited } = useLevel();
  const [text, setText] = useState(note?.text ?? '');
  const field = useRef<HTMLTextAreaElement>(null);
  const over = useRef(false);
  useEffect(() => {
    // a menu that has just closed restores the focus first
    const frame = requestAnimationFrame(() => field.current?.focus());
    return () => cancelAnimationFrame(frame);
  }, []);
  const close = (keep: boolean) => {
    if (over.current) return;
    over.current = true;
    onClose();
    const trimmed = text.trim();
    if (!keep || trimmed === (note?.text ?? '')) return;
    if (note !== null)
      edited.change(trimmed === '' ? 'Delete a note' : 'Edit a note', editPinnedNote(note.id, { text: trimmed }));
    else {
      const problem = pinProblem(edited.file());
      if (problem === null) edited.change('Add a note', pinNote(place.x, place.y, trimmed));
      else notices.show('warning', problem, { topic: 'refused' });
    }
  };
  const left = Math.max(8, Math.min(view.width - SIZE.width - 8, at.x + 14));
  const top = Math.max(8, Math.min(view.height - SIZE.height - 8, at.y + 14));
  return (
    <div
      className="pin__editor"
      role="dialog"
      aria-modal={false}
      aria-label={note === null ? 'New note' : 'Note'}
      style={{ left, top }}
      onBlur={({ currentTarget, relatedTarget }) => {
        if (!currentTarget.contains(relatedTarget)) close(true);
      }}
      onKeyDown={(event) => {
        if (event.key !== 'Escape' && !(event.key === 'Enter' && (event.ctrlKey || event.metaKey))) return;
        event.preventDefault();
        event.stopPropagation();
        close(event.key === 'Enter');
      }}
    >
      <textarea
        ref={field}
        className="field"
        rows={4}
        aria-label="Text of the note"
        maxLength={LONGEST_PINNED_NOTE}
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      <div className="canvas__does">
        {note !== null && (
          <Button
            hint="Delete the note"
            look="outlined"
            onClick={() => {
              over.current = true;
              edited.change('Delete a note', unpinNote(note.id));
              onClose();
            }}
          >
            Delete
          </Button>
        )}
        <Button hint="Keep the text" shortcut="Ctrl Enter" look="main" onClick={() => close(true)}>
          Done
        </Button>
      </div>
    </div>
  );
}
