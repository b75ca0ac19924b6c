import type { Editor } from '../../core/context/index.ts';
import { type Importing, importLevels } from '../../core/exchange/index.ts';
import { problemsInWords } from '../../core/files/index.ts';
import { addLevels } from '../../core/levels/index.ts';

/** What the user chose, dropped or pasted: the bytes of a file, or a text. */
export interface Given {
  readonly name: string;
  readonly content: Uint8Array | string;
}

/** The result of an import. */
export interface ImportResult {
  /** The number of levels that were added. */
  readonly added: number;
  /** What could not be imported, and why. */
  readonly refusals: readonly string[];
}

/** The topic of the notice about refused dropped files; the next import removes the notice. */
export const IMPORT_TOPIC = 'import';

/** Larger files are not read, bytes. */
const LARGEST = 4 * 1024 * 1024;

/** Adds the levels of some files to a folder and opens the first. Files too large for a level are not read. */
export async function importFiles(
  editor: Editor,
  folder: string,
  files: readonly File[],
  recoil: boolean,
): Promise<ImportResult> {
  const given: Given[] = [];
  const refusals: string[] = [];
  for (const file of files) {
    if (file.size > LARGEST)
      refusals.push(
        `${file.name}: expected a level file of a few kB, found ${Math.round(file.size / 1e6)} MB. Choose a .level.json file.`,
      );
    else given.push({ name: file.name, content: new Uint8Array(await file.arrayBuffer()) });
  }
  const taken = await importContents(editor, folder, given, recoil);
  return { ...taken, refusals: [...refusals, ...taken.refusals] };
}

/** Adds the levels of some texts to a folder and opens the first; reports what was left out. */
export async function importContents(
  editor: Editor,
  folder: string,
  given: readonly Given[],
  recoil: boolean,
): Promise<ImportResult> {
  const { notices } = editor;
  const wanted: { stem: string; file: Extract<Importing, { ok: true }>['levels'][number]['file'] }[] = [];
  const refusals: string[] = [];
  for (const { name, content } of given) {
    const importing = importLevels(content, name, { recoil });
    if (!importing.ok) {
      refusals.push(problemsInWords(name, importing.problems));
      continue;
    }
    wanted.push(...importing.levels.map(({ slug, file }) => ({ stem: slug, file })));
    for (const note of importing.notes) notices.show('info', `${name}: ${note}`);
  }
  if (wanted.length === 0) return { added: 0, refusals };
  const { length } = await addLevels(editor, folder, wanted);
  if (length > 0) notices.show('info', length === 1 ? '1 level was imported.' : `${length} levels were imported.`);
  return { added: length, refusals };
}
