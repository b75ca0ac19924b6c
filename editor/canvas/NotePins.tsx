import { MessageSquareText } from 'lucide-react';
import { type PointerEvent, type RefObject, useEffect, useRef, useState } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { useDocument, useEditor, useLevel, useSession } from '../core/context/index.ts';
import {
  editPinnedNote,
  type Gesture,
  LONGEST_PINNED_NOTE,
  type PinnedNote,
  pinNote,
  pinnedNotesIn,
  pinProblem,
  unpinNote,
} from '../core/document/index.ts';
import { Button } from '../core/ui/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { stepOf } from './crosshair-commands.ts';
import { type Point, toLevel, toScreen, type View } from './view.ts';

interface NotePinsProps {
  readonly canvas: StoreApi<CanvasState>;
  /** The element of the canvas. */
  readonly host: RefObject<HTMLElement | null>;
}

/** px of screen; a press on a pin that moves less opens it */
const SLOP = 4;

/** The notes of the level as pins, while it is edited: a click opens one, a drag or arrow keys move it, Delete removes it. */
export function NotePins({ canvas, host }: NotePinsProps) {
  const { session } = useEditor();
  const notes = useDocument(({ file }) => pinnedNotesIn(file));
  const isShown = useSession(({ layers, mode }) => layers.notes && mode === 'edit');
  const isEditing = useSession(({ mode }) => mode === 'edit');
  const open = useSession((state) => state.openNote);
  const view = useStore(canvas, (state) => state.view);
  if (!isEditing) return null;
  const note = typeof open === 'string' ? (notes.find(({ id }) => id === open) ?? null) : null;
  const place = typeof open === 'string' ? note : open;
  return (
    <>
      {isShown && notes.map((one) => <Pin key={one.id} note={one} canvas={canvas} host={host} />)}
      {place !== null && (
        <NoteEditor
          key={note?.id ?? 'new'}
          note={note}
          place={place}
          at={toScreen(view, place)}
          view={view}
          onClose={() => session.setState({ openNote: null })}
        />
      )}
    </>
  );
}

function Pin({ note, canvas, host }: NotePinsProps & { readonly note: PinnedNote }) {
  const { session, settings } = useEditor();
  const { document: edited } = useLevel();
  const view = useStore(canvas, (state) => state.view);
  const drag = useRef<{ readonly x: number; readonly y: number; gesture: Gesture | null } | null>(null);
  const { x, y } = toScreen(view, note);
  if (x < 0 || y < 0 || x > view.width || y > view.height) return null;

  const onPointerMove = (event: PointerEvent) => {
    const now = drag.current;
    const box = host.current?.getBoundingClientRect();
    if (now === null || box === undefined) return;
    if (now.gesture === null && Math.hypot(event.clientX - now.x, event.clientY - now.y) < SLOP) return;
    now.gesture ??= edited.begin('Move a note');
    const place = toLevel(view, { x: event.clientX - box.left, y: event.clientY - box.top });
    now.gesture.set(editPinnedNote(note.id, { x: Math.round(place.x), y: Math.round(place.y) }));
  };
  const end = (isDone: boolean) => {
    const now = drag.current;
    drag.current = null;
    if (now === null) return;
    if (now.gesture === null) {
      if (isDone) session.setState({ openNote: note.id });
    } else if (isDone) now.gesture.commit();
    else now.gesture.cancel();
  };
  return (
    <button
      type="button"
      className="pin"
      aria-label={`Note: ${note.text}, at ${note.x}, ${note.y}`}
      title={note.text}
      style={{ transform: `translate(${x}px, ${y}px)` }}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { x: event.clientX, y: event.clientY, gesture: null };
      }}
      onPointerMove={onPointerMove}
      onPointerUp={() => end(true)}
      onPointerCancel={() => end(false)}
      onKeyDown={(event) => {
        const { x: right, y: down } = stepOf(event.nativeEvent);
        const size = event.shiftKey ? settings.getState().grid : 1;
        if (event.key === 'Enter' || event.key === ' ') session.setState({ openNote: note.id });
        else if (event.key === 'Delete' || event.key === 'Backspace') edited.change('Delete a note', unpinNote(note.id));
        else if (event.key === 'Escape' && drag.current !== null) end(false);
        else if (right !== 0 || down !== 0) {
          const to = { x: note.x + right * size, y: note.y + down * size };
          edited.change('Move a note', editPinnedNote(note.id, to), { gesture: `note ${note.id}` });
        } else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    >
      <MessageSquareText size={15} aria-hidden />
    </button>
  );
}

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
function NoteEditor({ note, place, at, view, onClose }: NoteEditorProps) {
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
