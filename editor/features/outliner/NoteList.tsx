import { MessageSquareText } from 'lucide-react';
import type { LevelFile } from '../../../schema/index.ts';
import { useEditor } from '../../core/context/index.ts';
import { type PinnedNote, pinnedNotesIn } from '../../core/document/index.ts';

/** The notes of the level; each goes to its place and opens there. */
export function NoteList({ file }: { readonly file: LevelFile }) {
  const { session } = useEditor();
  const notes = pinnedNotesIn(file);
  if (notes.length === 0) return null;
  const go = ({ id, x, y }: PinnedNote) => {
    const { layers } = session.getState();
    session.setState({ lookAt: { x, y }, openNote: id, layers: { ...layers, notes: true } });
  };
  return (
    <section className="outliner__notes" aria-label="Notes">
      {notes.map((note) => (
        <button key={note.id} type="button" className="outliner__note" title={note.text} onClick={() => go(note)}>
          <MessageSquareText size={14} aria-hidden />
          <span className="outliner__name">{note.text}</span>
        </button>
      ))}
    </section>
  );
}
