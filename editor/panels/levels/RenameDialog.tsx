import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { LEVEL_ID_PART } from '../../../schema/index.ts';
import { useEditor } from '../../context/index.ts';
import { Button, Dialog } from '../../ui/index.ts';
import { folderOf, inFolder, renameTitle, stemOf } from './level-files.ts';

/** What is wrong with a name for a file; null: nothing. @param taken ids of other levels */
export function fileNameProblem(folder: string, stem: string, taken: readonly string[]): string | null {
  if (!LEVEL_ID_PART.test(stem)) return 'letters, digits, - _ and spaces inside, at most 80; it begins with a letter or a digit';
  const id = inFolder(folder, stem).toLowerCase();
  return taken.some((other) => other.toLowerCase() === id) ? 'another level has this file name' : null;
}

/** Another name for a level, for its file, or both. */
export function RenameDialog({ id, onClose }: { readonly id: string; readonly onClose: () => void }) {
  const editor = useEditor();
  const { workspace } = editor;
  const list = useStore(workspace.store, (state) => state.list);
  const entry = list?.levels.find((other) => other.id === id);
  const open = editor.open.getState();
  const [oldName] = useState(open?.opened.id() === id ? open.document.file().name : (entry?.name ?? null));
  const [name, setName] = useState(oldName ?? '');
  const [stem, setStem] = useState(stemOf(id));
  const [folder, setFolder] = useState(folderOf(id));
  const [refusal, setRefusal] = useState<string | null>(null);
  const [busy, setBusy] = useState(false);
  const field = useId();
  if (entry === undefined || list === null) return null;

  const taken = list.levels.filter((other) => other !== entry).map((other) => other.id);
  const problem = fileNameProblem(folder, stem, taken);
  const noName = oldName !== null && name.trim() === '';
  const rename = async () => {
    if (problem !== null || noName || busy) return;
    setBusy(true);
    const to = inFolder(folder, stem);
    if (to !== id) {
      const answer = await workspace.rename(entry, to);
      if (!answer.ok) {
        setRefusal(`${answer.error.message}. ${answer.error.hint}.`);
        setBusy(false);
        return;
      }
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
            <label htmlFor={`${field}-name`}>Name of the level</label>
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
        <label htmlFor={`${field}-file`}>Name of the file</label>
        <span className="form__file">
          <input
            id={`${field}-file`}
            className="field"
            value={stem}
            spellCheck={false}
            aria-invalid={problem !== null}
            aria-describedby={problem === null ? undefined : `${field}-problem`}
            onChange={(event) => setStem(event.target.value)}
          />
          .level.json
        </span>
        {list.folders.length > 1 && (
          <>
            <label htmlFor={`${field}-folder`}>Folder</label>
            <select id={`${field}-folder`} className="field" value={folder} onChange={(event) => setFolder(event.target.value)}>
              {list.folders.map((path) => (
                <option key={path} value={path}>
                  {path === '' ? list.folder.path : path}
                </option>
              ))}
            </select>
          </>
        )}
        {(problem ?? refusal) !== null && (
          <p id={`${field}-problem`} className="form__problem" role="alert">
            {problem ?? refusal}
          </p>
        )}
        <div className="form__buttons">
          <Button hint="Leave it as it is" look="outlined" onClick={onClose}>
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
