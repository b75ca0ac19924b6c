import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { renameLevel as renameInPack } from '../../../check/pack/index.ts';
import { useEditor } from '../../core/context/index.ts';
import { errorInWords, folderOf } from '../../core/files/index.ts';
import { changePack, inFolder, renameTitle, stemOf } from '../../core/levels/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import { FileNameFields, fileNameProblem } from './FileNameFields.tsx';

/** Renames a level, its file, or both. */
export function RenameDialog({ id, onClose }: { readonly id: string; readonly onClose: () => void }) {
  const editor = useEditor();
  const { workspace } = editor;
  const list = useStore(workspace.store, (state) => state.list);
  // as it was: the dialog stays until the order of the levels is written, too
  const [entry] = useState(() => list?.levels.find((other) => other.id === id));
  const open = editor.open.getState();
  const [oldName] = useState(open?.opened.id() === id ? open.document.file().name : (entry?.name ?? null));
  const [name, setName] = useState(oldName ?? '');
  const [stem, setStem] = useState(stemOf(id));
  const [folder, setFolder] = useState(folderOf(id));
  const [refusal, setRefusal] = useState<string | null>(null);
  const [busy, setBusy] = useState(false);
  const field = useId();
  if (entry === undefined || list === null) return null;

  const taken = list.levels.map((other) => other.id).filter((other) => other !== id);
  const problem = fileNameProblem(folder, stem, taken);
  const noName = oldName !== null && name.trim() === '';
  const rename = async () => {
    if (problem !== null || noName || busy) return;
    setBusy(true);
    const to = inFolder(folder, stem);
    if (to !== id) {
      const answer = await workspace.rename(entry, to);
      if (!answer.ok) {
        setRefusal(errorInWords(answer.error));
        setBusy(false);
        return;
      }
      await changePack(editor, {
        forward: (pack) => renameInPack(pack, id, to),
        backward: (pack) => renameInPack(pack, to, id),
      });
    }
    const now = workspace.store.getState().list?.levels.find((other) => other.id === to) ?? { ...entry, id: to };
    if (oldName !== null && name.trim() !== oldName) await renameTitle(editor, now, name.trim());
    onClose();
  };

  return (
    <Dialog open title="Rename" about={entry.file} onClose={onClose}>
      <form
        className="form"
        onSubmit={(event) => {
          event.preventDefault();
          void rename();
        }}
      >
        {oldName !== null && (
          <>
            <label htmlFor={`${field}-name`}>Level name</label>
            <input
              id={`${field}-name`}
              className="field"
              value={name}
              maxLength={120}
              autoFocus
              aria-invalid={noName}
              onChange={(event) => setName(event.target.value)}
            />
          </>
        )}
        <FileNameFields {...{ stem, folder, problem, refusal }} onStem={setStem} onFolder={setFolder} />
        <div className="form__buttons">
          <Button hint="Close without renaming" look="outlined" onClick={onClose}>
            Cancel
          </Button>
          <Button hint="Rename" look="main" type="submit" disabled={problem !== null || noName || busy}>
            Rename
          </Button>
        </div>
      </form>
    </Dialog>
  );
}
