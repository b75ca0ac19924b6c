import { CircleAlert, FolderOpen } from 'lucide-react';
import { useEffect, useId, useState } from 'react';
import { type Editor, useEditor } from '../../core/context/index.ts';
import { chooseFiles, type Importing, importLevels } from '../../core/exchange/index.ts';
import { folderOf, problemsInWords } from '../../core/files/index.ts';
import { addLevels } from '../../core/levels/index.ts';
import { FolderSelect } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';

/** Imports levels of this toolkit or of the original game from files or text. */
export function ImportTab({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [text, setText] = useState('');
  const [recoil, setRecoil] = useState(true);
  const [folder, setFolder] = useState(() => folderOf(editor.workspace.store.getState().opened?.id() ?? ''));
  const [busy, setBusy] = useState(false);
  const field = useId();
  const [refusals, setRefusals] = useState<readonly string[]>([]);
  const take = async (act: () => Promise<ImportResult>) => {
    setBusy(true);
    setRefusals([]);
    const { added, refusals: refused } = await act();
    setBusy(false);
    setRefusals(refused);
    if (added > 0 && refused.length === 0) onClose();
  };
  const choose = async () => {
    const files = await chooseFiles();
    if (files !== null) await take(() => importFiles(editor, folder, files, recoil));
  };
  // A notice about refused dropped files is outdated now.
  useEffect(() => editor.notices.clear(IMPORT_TOPIC), [editor]);
  return (
    <div className="share form">
      <p className="share__about">
        Import level files or level lists of the original game. You can also drop files anywhere on the page. Every level is added
        as a new level; none is replaced.
      </p>
      <div className="share__buttons">
        <Button
          hint="Choose one or more files"
          look="main"
          icon={<FolderOpen size={15} />}
          disabled={busy}
          onClick={() => void choose()}
        >
          Choose files…
        </Button>
        <label className="share__check">
          <input type="checkbox" checked={recoil} onChange={(event) => setRecoil(event.target.checked)} />
          keep the recoil of original levels
        </label>
      </div>
      <FolderSelect value={folder} onChange={setFolder} />
      <label htmlFor={field}>Or paste their text</label>
      <textarea
        id={field}
        className="field share__paste"
        rows={8}
        spellCheck={false}
        placeholder='{ "version": 1, "name": … }  or  [{ "player": … }]'
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      {refusals.length > 0 && (
        <ul className="share__refusals" role="alert" aria-label="Not imported">
          {refusals.map((refusal) => (
            <li key={refusal}>
              <CircleAlert size={14} aria-hidden /> {refusal}
            </li>
          ))}
        </ul>
      )}
      <div className="form__buttons">
        <Button
          hint="Add the levels in the text as new levels"
          look="outlined"
          disabled={busy || text.trim() === ''}
          onClick={() => void take(() => importContents(editor, folder, [{ name: 'pasted text', content: text }], recoil))}
        >
          Import text
        </Button>
      </div>
    </div>
  );
}

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
