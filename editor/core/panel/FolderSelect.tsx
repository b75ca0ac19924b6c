import { useId } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../context/index.ts';

/** Selects the folder of a level; hidden if there is only one. */
export function FolderSelect({ value, onChange }: { readonly value: string; readonly onChange: (folder: string) => void }) {
  const { workspace } = useEditor();
  const list = useStore(workspace.store, (state) => state.list);
  const id = useId();
  if (list === null || list.folders.length < 2) return null;
  return (
    <>
      <label htmlFor={id}>Folder</label>
      <select id={id} className="field" value={value} onChange={(event) => onChange(event.target.value)}>
        {list.folders.map((folder) => (
          <option key={folder} value={folder}>
            {folder === '' ? list.folder.path : folder}
          </option>
        ))}
      </select>
    </>
  );
}
