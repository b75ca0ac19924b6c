import { EyeOff } from 'lucide-react';
import { useDocument, useEditor, useSession } from '../core/context/index.ts';
import { hiddenIn } from '../core/document/index.ts';
import { Button } from '../core/ui/index.ts';

/** How many objects are hidden, with the way to show them. */
export function HiddenNote() {
  const { commands } = useEditor();
  const count = useDocument(({ file }) => hiddenIn(file).size);
  const isEditing = useSession(({ mode }) => mode === 'edit');
  if (count === 0 || !isEditing) return null;
  const what = count === 1 ? '1 object hidden: the run still meets it' : `${count} objects hidden: the run still meets them`;
  return (
    <div className="canvas__hidden" role="status" aria-label="Hidden objects">
      <EyeOff size={14} aria-hidden /> {what}
      <Button hint="Show all hidden objects" look="outlined" onClick={() => commands.run('object.show-all')}>
        Show
      </Button>
    </div>
  );
}
