import { RotateCcw } from 'lucide-react';
import { usePromised } from '../../core/ask/index.ts';
import { useEditor, useOverlay } from '../../core/context/index.ts';
import { errorInWords } from '../../core/files/index.ts';
import { restoreLevel } from '../../core/levels/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';

/** The deleted levels, which can be restored. */
export function TrashDialog() {
  const dialog = useOverlay('trash');
  return (
    <Dialog {...dialog} title="Deleted levels" about="Deleted levels are kept here and are never removed.">
      <Trash onClose={dialog.onClose} />
    </Dialog>
  );
}

function Trash({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const { storage } = editor.workspace;
  const answer = usePromised(storage, (asked) => asked.trash());
  if (answer === null) return <p>Loading…</p>;
  if (!answer.ok) return <p role="alert">{errorInWords(answer.error)}</p>;
  const entries = answer.value;
  if (entries.length === 0) return <p className="trash__empty">No deleted levels.</p>;
  return (
    <ul className="trash">
      {entries.map(({ trash, id, deleted }) => (
        <li key={trash} className="trash__entry">
          <span className="trash__name">{id}</span>
          <time className="trash__time" dateTime={deleted}>
            {new Date(deleted).toLocaleString()}
          </time>
          <Button
            hint={`Restore ${id} and open it`}
            look="outlined"
            icon={<RotateCcw size={14} />}
            onClick={() => {
              onClose();
              void restoreLevel(editor, trash, true);
            }}
          >
            Restore
          </Button>
        </li>
      ))}
    </ul>
  );
}
