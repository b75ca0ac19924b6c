import type { LevelFile } from '../../../schema/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { addLevels, copyOf } from '../../core/levels/index.ts';

/** Makes a new level file of a version and opens it. @returns whether it was made; a refusal is shown as a notice */
export async function openAsCopy(editor: Editor, id: string, file: LevelFile): Promise<boolean> {
  const levels = editor.workspace.store.getState().list?.levels ?? [];
  const { stem, name } = copyOf(levels, id, file.name);
  return (await addLevels(editor, folderOf(id), [{ stem, file: { ...file, name } }])).length > 0;
}
